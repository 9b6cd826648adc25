#include "ratchet_sieve/analysis/run_analysis.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "hand_made_result.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "recording/errors.h"
#include "recording/small_scenes.h"

namespace ratchet_sieve
{
namespace
{

/// Runs a scene to its end with the analysis as sink.
RunResult analyzed(Simulation& simulation, double particle_rate = 60.0)
{
  RunAnalysis analysis;
  RunWatchers watchers;
  watchers.frames = {{&analysis}};
  watchers.frames[0].rates.particles = particle_rate;
  runToEnd(simulation, watchers);
  return analysis.result();
}

SceneFrame sceneFrame(const SceneDefinition& scene)
{
  return makeSceneFrame(Simulation(scene));
}

TEST(RunAnalysis, FindsTheEnginesVelocitiesFromDisplacementsAlone)
{
  SceneDefinition scene = smallRing();
  scene.settle = 0.25;  // equal to the time of a frame
  scene.contact.pair_collisions =
      false;  // errors over disks only, because blocks of time differ from the engine's
  Simulation simulation(scene);
  const RunResult result = analyzed(simulation);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_NEAR(result.velocities[i].mean.value(), simulation.means()[i].mean_vx.value(), 1e-12);
    EXPECT_NEAR(result.velocities[i].mean_stderr.value(), simulation.means()[i].mean_vx_stderr.value(),
                1e-12);
    EXPECT_EQ(result.velocities[i].disks, 2u);
  }
}

/// A recording has fewer frames of the disks than of the other kinds.
TEST(RunAnalysis, SaysTheSameOfDisksThatAreSeenMoreSeldom)
{
  SceneDefinition scene = smallRing();
  scene.duration = 4.0;
  Simulation often(scene), seldom(scene);
  const RunResult full = analyzed(often);
  const RunResult decimated = analyzed(seldom, 10.0);
  EXPECT_EQ(full.particle_frames, 241u);
  EXPECT_EQ(decimated.particle_frames, 41u);
  EXPECT_EQ(decimated.granular_temperatures, full.granular_temperatures);
  EXPECT_EQ(decimated.shortToLong(), full.shortToLong());
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(decimated.velocities[i].mean, full.velocities[i].mean);
    EXPECT_EQ(decimated.velocities[i].disks, full.velocities[i].disks);
    EXPECT_TRUE(full.velocities[i].mean_stderr);
    EXPECT_FALSE(decimated.velocities[i].mean_stderr) << "40 steps are too few";
  }
  ASSERT_EQ(decimated.displacement_distributions.size(), full.displacement_distributions.size());
  for (std::size_t k = 0; k < full.displacement_distributions.size(); ++k)
  {
    EXPECT_EQ(decimated.displacement_distributions[k].time, full.displacement_distributions[k].time);
    EXPECT_EQ(decimated.displacement_distributions[k].counts, full.displacement_distributions[k].counts);
  }
}

TEST(RunAnalysis, KeepsBinsWhereTheyChange)
{
  Simulation simulation(smallMixture());
  const RunResult result = analyzed(simulation);
  EXPECT_EQ(result.bins.front().time, 0.0);
  EXPECT_EQ(result.bins.back().time, 2.0);
  ASSERT_LE(result.bins.size(), 2u + 12u);
  for (std::size_t i = 1; i + 1 < result.bins.size(); ++i)
    EXPECT_LT(result.bins[i].bins[0].on_base + result.bins[i].bins[1].on_base,
              result.bins[i - 1].bins[0].on_base + result.bins[i - 1].bins[1].on_base);
}

/// A machine with an endless feed changes its bins for ever.
TEST(RunAnalysis, KeepsNotMoreBinsThanAnotherSeriesUnlessEveryChangeIsWanted)
{
  constexpr std::uint64_t CHANGES = 10000;
  for (const bool every_change : {true, false})
  {
    RunAnalysis analysis(every_change);
    analysis.take(sceneFrame(smallMixture()));
    for (std::uint64_t k = 0; k <= CHANGES; ++k)
    {
      BinFrame frame;
      frame.time = 0.25 * static_cast<double>(k);
      frame.bins.resize(2);
      frame.bins[1].left = k;
      analysis.take(frame);
    }
    const RunResult result = analysis.result();
    EXPECT_EQ(result.bins.front().bins[1].left, 0u);
    EXPECT_EQ(result.bins.back().bins[1].left, CHANGES);
    EXPECT_EQ(result.bins.size() > CHANGES, every_change);
    EXPECT_LT(result.bins.size(), every_change ? CHANGES + 2 : 4100u);
  }
}

StatisticsFrame temperaturesAt(double time, std::vector<double> temperatures)
{
  StatisticsFrame frame;
  frame.time = time;
  frame.window_start = std::max(0.0, time - 0.5);
  frame.window_end = time;
  for (const double temperature : temperatures)
    frame.species.push_back({"", {}, temperature > 0.0 ? std::optional<double>(temperature) : std::nullopt});
  return frame;
}

TEST(RunAnalysis, AveragesTemperaturesWhereThereWereDisksAndAfterSettle)
{
  SceneDefinition scene = smallMixture();
  scene.settle = 1.0;
  RunAnalysis analysis;
  analysis.take(sceneFrame(scene));
  analysis.take(temperaturesAt(0.5, {100.0, 100.0}));
  analysis.take(temperaturesAt(1.25, {50.0, 50.0}));  // of 0.75 s to 1.25 s
  analysis.take(temperaturesAt(1.5, {1.0, 0.0}));
  analysis.take(temperaturesAt(2.0, {3.0, 0.0}));
  analysis.take(temperaturesAt(3.0, {0.0, 0.0}));
  const RunResult result = analysis.result();
  EXPECT_DOUBLE_EQ(result.granular_temperatures[0].value(), 2.0);
  EXPECT_FALSE(result.granular_temperatures[1]);
}

TEST(RunAnalysis, ThinsALongSeriesEvenly)
{
  RunAnalysis analysis;
  analysis.take(sceneFrame(smallRing()));
  for (int k = 0; k < 20'000; ++k)
  {
    BaseFrame frame;
    frame.time = k;
    analysis.take(frame);
  }
  const std::vector<BaseFrame> kept = analysis.result().base;
  ASSERT_EQ(kept.size(), 2501u);
  for (std::size_t i = 0; i + 1 < kept.size(); ++i)
    EXPECT_EQ(kept[i].time, 8.0 * static_cast<double>(i));
  EXPECT_EQ(kept.back().time, 19'999.0);
}

TEST(RunAnalysis, BeginsAnewWithANewScene)
{
  RunAnalysis analysis;
  analysis.take(sceneFrame(smallMixture()));
  analysis.take(particlesAt(1.0, {diskAt(0, 0, 1.0)}));
  analysis.take(sceneFrame(smallRing()));
  EXPECT_EQ(analysis.result().particle_frames, 0u);
  EXPECT_EQ(analysis.result().end, 0.0);
}

TEST(RunAnalysis, RefusesFramesThatDoNotFitTogether)
{
  RunAnalysis analysis;
  EXPECT_THROW(analysis.result(), AnalysisError);
  const auto expectRefused = [&](const AnyFrame& frame, const std::string& because)
  { EXPECT_EQ(errorOf<AnalysisError>([&] { analysis.take(frame); }), because); };
  expectRefused(particlesAt(0.5, {}), "a frame of particles at 0.5 s comes before any scene");
  analysis.take(sceneFrame(smallMixture()));
  expectRefused(particlesAt(0.5, {diskAt(3, 2, 0.0)}),
                "disk 3 at 0.5 s has species 2, and the scene 2 of them");
  expectRefused(BinFrame{}, "a frame of bins with 0 species does not fit the scene, which has 2");
  expectRefused(temperaturesAt(0.0, {1.0}),
                "a frame of statistics with 1 species does not fit the scene, which has 2");
  expectRefused(ObservedFrame{0.0, {{"../mass_flow", {}}}},
                "a frame of observed has ../mass_flow, which the scene does not observe");
  const std::vector<ObservedColumn> uneven = {{"left", "", {1.0}}, {"right", "", {}}};
  expectRefused(ObservedFrame{0.0, {{SIZE_CLASSES, {{"", "A", {}, uneven}}}}},
                "a frame of observed has columns of different lengths in size_classes");
}

TEST(RunAnalysis, LeavesUndefinedWhatARunOfNothingDoesNotHave)
{
  RunAnalysis analysis;
  analysis.take(sceneFrame(smallMixture()));
  const RunResult result = analysis.result();
  EXPECT_FALSE(result.velocities[0].mean);
  EXPECT_FALSE(result.shortToLong());
  EXPECT_EQ(result.lastBins(), nullptr);
  EXPECT_EQ(result.lastStatistics(), nullptr);
}

}  // namespace
}  // namespace ratchet_sieve
