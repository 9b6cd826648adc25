#include "ratchet_sieve/recording/frames.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

TEST(SceneFrame, CarriesTheSceneAsItRuns)
{
  SceneDefinition scene = smallMixture();
  scene.seed = 77;
  const SceneFrame frame = makeSceneFrame(Simulation(scene));
  EXPECT_EQ(frame.seed, 77u);
  EXPECT_EQ(frame.version, version());
  EXPECT_EQ(frame.scene_hash, sceneHash(scene));
  EXPECT_EQ(canonicalYaml(sceneFromText(frame.yaml, "frame").definition), canonicalYaml(scene));
}

TEST(Frames, ShowTheSimulationAtItsTime)
{
  Simulation simulation(smallMixture());
  simulation.advanceTo(0.5);
  const ParticleFrame particles = makeParticleFrame(simulation);
  EXPECT_EQ(particles.time, 0.5);
  EXPECT_EQ(particles.disks.size(), simulation.activeDisks());
  const BaseFrame base = makeBaseFrame(simulation);
  EXPECT_EQ(base.time, 0.5);
  EXPECT_EQ(base.base.frequency, 23.0);
}

TEST(BinFrame, CountsAndRates)
{
  Simulation simulation(smallMixture());
  EXPECT_FALSE(makeBinFrame(simulation).quality);
  EXPECT_FALSE(makeBinFrame(simulation).processed);
  simulation.advanceTo(2.0);
  const BinFrame frame = makeBinFrame(simulation);
  EXPECT_EQ(frame.species, (std::vector<std::string>{"A", "B"}));
  ASSERT_GT(frame.bins[0].counted() + frame.bins[1].counted(), 0u);
  EXPECT_EQ(frame.bins[0].counted() + frame.bins[0].on_base, 6u);
  EXPECT_EQ(frame.processed, processedRatio(frame.bins));
  EXPECT_EQ(frame.quality, bestSeparation(frame.bins).quality());
}

TEST(StatisticsFrame, ShowsItsWindow)
{
  Simulation simulation(smallRing());
  StatisticsWindow window;
  simulation.observePeriods([&](const PeriodRecord& period) { window.take(period); });
  simulation.advanceTo(0.9);
  window.moveTo(simulation);
  const StatisticsFrame frame = makeStatisticsFrame(simulation, window);
  EXPECT_EQ(frame.species.size(), 2u);
  EXPECT_EQ(frame.window_start, 0.0);
  EXPECT_EQ(frame.window_end, window.end());
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(frame.species[i].granular_temperature, window.granularTemperatures()[i]);
  EXPECT_EQ(frame.collision_rates.total(), window.collisionRates().total());
  EXPECT_GT(frame.collision_rates.total(), 0.0);
  EXPECT_EQ(frame.real_time_factor, 0.0);
}

}  // namespace
}  // namespace ratchet_sieve
