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
  EXPECT_EQ(frame.quality, bestQuality(frame.bins));
}

TEST(StatisticsFrame, GivesRatesBetweenTwoFrames)
{
  Simulation simulation(smallRing());
  simulation.advanceTo(0.4);
  const StatisticsFrame first = makeStatisticsFrame(simulation, nullptr, 0.0);
  EXPECT_EQ(first.collision_rate, 0.0);
  EXPECT_EQ(first.real_time_factor, 0.0);
  simulation.advanceTo(0.9);
  const StatisticsFrame second = makeStatisticsFrame(simulation, &first, 0.25);
  ASSERT_GT(second.collisions.total(), first.collisions.total());
  EXPECT_DOUBLE_EQ(second.collision_rate,
                   static_cast<double>(second.collisions.total() - first.collisions.total()) / 0.5);
  EXPECT_DOUBLE_EQ(second.real_time_factor, 2.0);
  EXPECT_EQ(second.means.size(), 2u);
}

TEST(StatisticsFrame, HasNoRateWhereNoTimePassed)
{
  Simulation simulation(smallRing());
  const StatisticsFrame first = makeStatisticsFrame(simulation, nullptr, 0.0);
  const StatisticsFrame second = makeStatisticsFrame(simulation, &first, 0.0);
  EXPECT_EQ(second.collision_rate, 0.0);
  EXPECT_EQ(second.real_time_factor, 0.0);
}

DiskState moving(std::uint32_t species, double vx, double vy)
{
  DiskState disk;
  disk.species = species;
  disk.vx = vx;
  disk.vy = vy;
  return disk;
}

TEST(GranularTemperature, IsHalfTheMassTimesTheVariance)
{
  // Species 0: vx = 1, 3 (variance 1), vy = 0, 4 (variance 4): 0.5 * 2 kg * 5. Species 1: one disk. Species
  // 2: none.
  const std::vector<DiskState> disks = {moving(0, 1.0, 0.0), moving(0, 3.0, 4.0), moving(1, 9.0, 9.0)};
  EXPECT_EQ(granularTemperatures(disks, {2.0, 1.0, 1.0}), (std::vector<double>{5.0, 0.0, 0.0}));
}

TEST(GranularTemperature, DoesNotFeelACommonDrift)
{
  const double drift = 1e6;
  const std::vector<DiskState> disks = {moving(0, drift + 1.0, 0.0), moving(0, drift + 3.0, 4.0)};
  EXPECT_NEAR(granularTemperatures(disks, {2.0})[0], 5.0, 1e-9);
}

}  // namespace
}  // namespace ratchet_sieve
