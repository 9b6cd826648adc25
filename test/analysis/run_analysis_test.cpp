#include "ratchet_sieve/analysis/run_analysis.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "hand_made_frames.h"
#include "ratchet_sieve/analysis/analysis_report.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/summary.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"
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

TEST(RunAnalysis, KnowsTheSceneThatRan)
{
  Simulation simulation(smallRing());
  const RunResult result = analyzed(simulation);
  EXPECT_EQ(canonicalYaml(result.scene), canonicalYaml(smallRing()));
  EXPECT_EQ(result.species, (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(result.start, 0.0);
  EXPECT_EQ(result.end, 1.0);
  EXPECT_EQ(result.particle_frames, 61u);
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

TEST(RunAnalysis, SaysTheCollisionRatesOfTheSummary)
{
  SceneDefinition scene = smallRing();
  scene.settle = 0.25;
  Simulation simulation(scene);
  RunAnalysis analysis;
  RunWatchers watchers;
  watchers.frames = {{&analysis}};
  const auto summary = summarize(simulation, runToEnd(simulation, watchers));
  const auto report = reportJson(analysis.result());
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_GT(summary["species"][i]["collision_rate"].get<double>(), 0.0);
    for (const char* key : {"collision_rate", "kinetic_translational", "kinetic_rotational"})
      EXPECT_EQ(report["species"][i][key], summary["species"][i][key]) << key;
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

/// Disks that leave are last seen up to one frame earlier.
TEST(RunAnalysis, LosesTheLastStretchOfDisksThatFallOff)
{
  SceneDefinition scene = smallMixture();
  scene.base.teeth = 10;
  scene.base.inclination = -0.1;
  scene.species[0].count = scene.species[1].count = 20;
  scene.duration = 10.0;
  Simulation often(scene), seldom(scene);
  const RunResult full = analyzed(often);
  const RunResult decimated = analyzed(seldom, 10.0);
  ASSERT_GT(full.lastBins()->processed.value(), 0.5);
  EXPECT_EQ(decimated.lastBins()->quality, full.lastBins()->quality);
  EXPECT_EQ(decimated.lastBins()->processed, full.lastBins()->processed);
  for (std::size_t i = 0; i < 2; ++i)
  {
    // Two of each leave within the first 0.1 s: seen only once, they have no velocity.
    EXPECT_EQ(decimated.velocities[i].disks + 2, full.velocities[i].disks);
    EXPECT_NEAR(decimated.velocities[i].mean.value(), full.velocities[i].mean.value(),
                full.velocities[i].mean_stderr.value());
  }
}

TEST(RunAnalysis, EndsWithTheEnginesBinsAndContacts)
{
  Simulation simulation(smallMixture());
  const RunResult result = analyzed(simulation);
  const std::vector<SpeciesBins> bins = simulation.bins();
  ASSERT_GT(bins[0].counted() + bins[1].counted(), 0u);
  ASSERT_NE(result.lastBins(), nullptr);
  for (std::size_t i = 0; i < 2; ++i)
  {
    EXPECT_EQ(result.lastBins()->bins[i].left, bins[i].left);
    EXPECT_EQ(result.lastBins()->bins[i].right, bins[i].right);
    EXPECT_EQ(result.lastBins()->bins[i].on_base, bins[i].on_base);
  }
  EXPECT_EQ(result.lastBins()->quality, bestSeparation(bins).quality());
  EXPECT_EQ(result.lastBins()->processed, processedRatio(bins));
  EXPECT_EQ(result.lastStatistics()->collisions.right_slope, simulation.collisions().right_slope);
  EXPECT_EQ(result.shortToLong(), simulation.collisions().shortToLong(0.1));
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

TEST(RunAnalysis, BeginsAnewWithANewScene)
{
  RunAnalysis analysis;
  analysis.take(sceneFrame(smallMixture()));
  analysis.take(particlesAt(1.0, {diskAt(0, 0, 1.0)}));
  analysis.take(sceneFrame(smallRing()));
  EXPECT_EQ(analysis.result().particle_frames, 0u);
  EXPECT_EQ(analysis.result().end, 0.0);
}

/// The message of the AnalysisError that an action throws.
template <typename Action>
std::string refusal(Action&& action)
{
  try
  {
    action();
    return "";
  }
  catch (const AnalysisError& error)
  {
    return error.what();
  }
}

TEST(RunAnalysis, RefusesFramesThatDoNotFitTogether)
{
  RunAnalysis analysis;
  EXPECT_EQ(refusal([&] { analysis.result(); }), "no scene was recorded");
  EXPECT_EQ(refusal([&] { analysis.take(particlesAt(0.5, {})); }),
            "a frame of particles at 0.5 s comes before any scene");
  analysis.take(sceneFrame(smallMixture()));
  EXPECT_EQ(refusal([&] { analysis.take(particlesAt(0.5, {diskAt(3, 2, 0.0)})); }),
            "disk 3 at 0.5 s has species 2, and the scene 2 of them");
  EXPECT_EQ(refusal([&] { analysis.take(BinFrame{}); }),
            "a frame of bins with 0 species does not fit the scene, which has 2");
  EXPECT_EQ(refusal([&] { analysis.take(temperaturesAt(0.0, {1.0})); }),
            "a frame of statistics with 1 species does not fit the scene, which has 2");
}

TEST(RunAnalysis, RefusesNumbersThatNoRunHas)
{
  RunAnalysis analysis;
  analysis.take(sceneFrame(smallRing()));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double displacement : {nan, 1e300, -std::numeric_limits<double>::infinity()})
    EXPECT_THROW(analysis.take(particlesAt(0.5, {diskAt(0, 0, displacement)})), AnalysisError)
        << displacement;
  BinFrame bins;
  bins.bins.resize(2);
  bins.bins[1].left = std::uint64_t{1} << 63;
  EXPECT_THROW(analysis.take(bins), AnalysisError);
  BaseFrame base;
  base.base.frequency = nan;
  EXPECT_THROW(analysis.take(base), AnalysisError);
  StatisticsFrame statistics;
  statistics.species.resize(2);
  statistics.species[1].granular_temperature = nan;
  EXPECT_EQ(refusal([&] { analysis.take(statistics); }),
            "a frame of statistics at 0 s holds a number that is not finite: granular_temperature");
  statistics.species[1].granular_temperature = 0.0;
  statistics.species[0].means.mean_vx = nan;
  EXPECT_EQ(refusal([&] { analysis.take(statistics); }),
            "a frame of statistics at 0 s holds a number that is not finite: mean_vx");
}

/// What a frame names becomes a file's name and a table's lines.
TEST(RunAnalysis, RefusesObservationsThatDoNotFitTheScene)
{
  SceneDefinition scene = smallMixture();
  scene.observe = {"mass_flow"};
  RunAnalysis analysis;
  analysis.take(sceneFrame(scene));
  const auto refused = [&](const Observed& observed) {
    return refusal([&] { analysis.take(ObservedFrame{0.5, {observed}}); });
  };
  const std::string begin = "a frame of observed at 0.5 s does not fit the scene: ";
  const ObservedRow row{"left", "A", {}, {{"time", "s", {0.5}}, {"flow", "kg/s", {std::nullopt}}}};
  EXPECT_EQ(refused({"../mass_flow", {row}}), begin + "it does not observe ../mass_flow");
  EXPECT_EQ(refused({"height_profile", {row}}), begin + "it does not observe height_profile");
  EXPECT_EQ(refused({"mass_flow", {{"left", "C", {}, {}}}}), begin + "it has no species C");
  EXPECT_EQ(refused({"mass_flow", {{"above", "A", {}, {}}}}), begin + "it has no place above");
  EXPECT_EQ(refused({"mass_flow", {row, {"left", "A", {}, {{"time", "s", {0.5}}}}}}),
            begin + "columns of mass_flow differ in length");
  EXPECT_EQ(refused({"mass_flow", {{"left", "A", {}, {{"time", "s", {}}, {"flow", "kg/s", {1.0}}}}}}),
            begin + "columns of mass_flow differ in length");
  EXPECT_EQ(refused({"mass_flow", {{"left", "A", {{"mean", "kg/s", std::nan("")}}, {}}}}),
            "a frame of observed at 0.5 s holds a number that is not finite: value");
  EXPECT_EQ(analysis.result().missing().back(), "observed");
  analysis.take(ObservedFrame{0.5, {{"mass_flow", {row}}}});
  EXPECT_EQ(analysis.result().observed.at(0).rows.at(0).table.size(), 2u);
}

TEST(RunAnalysis, RefusesASceneThatIsNone)
{
  RunAnalysis analysis;
  SceneFrame frame;
  frame.yaml = "species: 3";
  EXPECT_THROW(analysis.take(frame), SceneError);
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
