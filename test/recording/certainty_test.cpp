// A run ends when it reaches the requested accuracy, always at the same time, and reports what it reached.
#include "ratchet_sieve/recording/certainty.h"

#include <gtest/gtest.h>

#include "collecting_sink.h"
#include "coverage.h"
#include "ratchet_sieve/recording/checkpoint.h"
#include "ratchet_sieve/recording/headless_run.h"
#include "ratchet_sieve/recording/summary.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition layer(double mean_vx)
{
  SceneDefinition scene = smallRing();
  scene.base.teeth = 2;
  scene.species[0].count = scene.species[1].count = 12;
  scene.species[1].radius = 0.002;
  scene.duration = 1000.0;
  scene.accuracy.mean_vx = mean_vx;
  return scene;
}

/// Fig. 3.
SceneDefinition ensemble(double mean_vx)
{
  SceneDefinition scene = smallRing();
  scene.base.asymmetry = 0.3;
  scene.contact.pair_collisions = false;
  scene.species.resize(1);
  scene.species[0].count = 128;
  scene.species[0].mass = 0.001;
  scene.duration = 1000.0;
  scene.accuracy.mean_vx = mean_vx;
  return scene;
}

/// Fig. 9, short, with a feed.
SceneDefinition fedSieve(double quality)
{
  SceneDefinition scene = smallMixture();
  scene.base.inclination = 0.1;
  scene.species[1].radius = 0.005;
  scene.feed.rate = 40.0;
  scene.duration = 1000.0;
  scene.accuracy.quality = quality;
  return scene;
}

/// One run per seed, each to its early end.
std::vector<Simulation> runs(SceneDefinition scene, std::uint64_t seeds)
{
  std::vector<Simulation> ended;
  for (scene.seed = 1; scene.seed <= seeds; ++scene.seed)
  {
    Simulation simulation(scene);
    EXPECT_EQ(runToEnd(simulation, {}).end, RunEnd::ACCURATE) << scene.seed;
    ended.push_back(std::move(simulation));
  }
  return ended;
}

/// Compared with the mean of all runs, whose error is ten times smaller.
void expectMeansAsClaimed(const SceneDefinition& scene, std::uint64_t seeds)
{
  const std::vector<Simulation> ended = runs(scene, seeds);
  for (std::size_t s = 0; s < scene.species.size(); ++s)
  {
    double sum = 0.0, weight = 0.0;
    std::vector<Estimate> estimates;
    for (const Simulation& simulation : ended)
    {
      const SteadyMeans means = certaintyOf(simulation).means;
      estimates.push_back(means.of[s]->estimate);
      sum += estimates.back().value * means.left;
      weight += means.left;
      EXPECT_LE(estimates.back().half_width, scene.accuracy.mean_vx);
    }
    Coverage coverage;
    for (const Estimate& estimate : estimates)
      coverage.take(std::abs(estimate.value - sum / weight) <= estimate.half_width);
    const double claimed = scene.accuracy.confidence;
    EXPECT_NEAR(coverage.share(), claimed, coverage.tolerance(claimed)) << scene.species[s].name;
  }
}

TEST(Certainty, OfALayerHoldsTheTruthAsOftenAsItClaims)
{
  SceneDefinition scene = layer(0.006);
  scene.base.asymmetry = 0.3;
  scene.accuracy.confidence = 0.8;
  expectMeansAsClaimed(scene, 80);
}

TEST(Certainty, OfSingleDisksHoldsTheTruthAsOftenAsItClaims)
{
  SceneDefinition scene = ensemble(0.002);
  scene.accuracy.confidence = 0.8;
  expectMeansAsClaimed(scene, 150);
}

TEST(Certainty, OfQHoldsTheTruthAsOftenAsItClaims)
{
  SceneDefinition scene = fedSieve(0.05);
  scene.accuracy.confidence = 0.8;
  const std::vector<Simulation> ended = runs(scene, 100);
  double sum = 0.0, weight = 0.0;
  for (const Simulation& simulation : ended)
  {
    sum += certaintyOf(simulation).separation->estimate.value * simulation.time();
    weight += simulation.time();
  }
  Coverage coverage;
  for (const Simulation& simulation : ended)
  {
    const Estimate quality = certaintyOf(simulation).separation->estimate;
    coverage.take(std::abs(quality.value - sum / weight) <= quality.half_width);
  }
  EXPECT_NEAR(coverage.share(), 0.8, coverage.tolerance(0.8));
}

/// Runs to the end, also from a checkpoint saved on the way.
void expectTheSameEnd(const SceneDefinition& scene)
{
  Simulation alone(scene);
  EXPECT_EQ(runToEnd(alone, {}).end, RunEnd::ACCURATE);
  EXPECT_LT(alone.time(), scene.duration);

  Simulation watched(scene);
  CollectingSink sink;
  RunWatchers watchers;
  watchers.frames = {{&sink}};
  watchers.frames[0].rates.particles = watchers.frames[0].rates.base = 7.0;
  watched.setThreads(2);
  EXPECT_EQ(runToEnd(watched, watchers).end, RunEnd::ACCURATE);
  EXPECT_EQ(sink.bins.back().time, alone.time());
  EXPECT_EQ(watched.saveState(), alone.saveState());

  const ScratchDirectory directory;
  Simulation begun(scene);
  begun.advanceTo(0.6 * alone.time());
  writeCheckpoint(directory / "half", begun, {});
  Simulation resumed = readCheckpoint(directory / "half", scene).simulation;
  EXPECT_EQ(runToEnd(resumed, {}, {}).end, RunEnd::ACCURATE);
  EXPECT_EQ(resumed.saveState(), alone.saveState());

  SceneDefinition loose = scene;
  loose.accuracy.mean_vx *= 1.5;
  Simulation sooner(loose);
  runToEnd(sooner, {});
  EXPECT_LT(sooner.time(), alone.time());
  writeCheckpoint(directory / "loose", sooner, {});
  Simulation tightened = readCheckpoint(directory / "loose", scene).simulation;
  runToEnd(tightened, {}, {});
  EXPECT_EQ(tightened.saveState(), alone.saveState());
  // A completed run does not continue.
  Simulation ended = readCheckpoint(directory / "loose", loose).simulation;
  EXPECT_EQ(runToEnd(ended, {}, {}).end, RunEnd::ACCURATE);
  EXPECT_EQ(ended.time(), sooner.time());
}

TEST(Certainty, EndsARunAtOneTimeHoweverItIsRun)
{
  expectTheSameEnd(layer(0.006));
  expectTheSameEnd(ensemble(0.001));
}

TEST(Certainty, IsLookedAtEverLessOften)
{
  const Simulation simulation(layer(0.01));
  double last = lookFrom(simulation, 0.0);
  EXPECT_EQ(last, simulation.blockEnd(32));
  EXPECT_EQ(lookFrom(simulation, last), last);
  for (int k = 0; k < 50; ++k)
  {
    const double next = lookFrom(simulation, 1.01 * last);
    EXPECT_GE(next, 1.19 * last);
    EXPECT_LE(next, 1.25 * last);
    last = next;
  }
}

TEST(Certainty, ThatIsNotReachedIsSaidWithWhatItWouldTake)
{
  SceneDefinition scene = layer(0.001);
  scene.duration = 20.0;
  Simulation simulation(scene);
  const RunOutcome outcome = runToEnd(simulation, {});
  EXPECT_EQ(outcome.end, RunEnd::COMPLETED);
  EXPECT_EQ(simulation.time(), 20.0);
  ASSERT_EQ(outcome.warnings.size(), 1u);
  EXPECT_EQ(outcome.warnings[0].rfind("accuracy.mean_vx = 0.001 m/s was not reached within 20 s: ± 0.0", 0),
            0u)
      << outcome.warnings[0];
  // The error is inversely proportional to the square root of the time.
  const double half_width = *certaintyOf(simulation).to_mean_vx->ratio * 0.001;
  const std::string marker = "a duration of about ";
  const double told = std::stod(outcome.warnings[0].substr(outcome.warnings[0].find(marker) + marker.size()));
  EXPECT_NEAR(told, 20.0 * std::pow(half_width / 0.001, 2.0), 0.2 * told);
  EXPECT_EQ(summarize(simulation, outcome)["accuracy"]["reached"], false);

  scene.duration = 0.3;
  Simulation brief(scene);
  EXPECT_EQ(runToEnd(brief, {}).warnings,
            std::vector<std::string>{"accuracy.mean_vx = 0.001 m/s was not reached within 0.3 s: the run is "
                                     "too short to estimate the error [mean-not-reached]"});
}

/// Any error is below 0.5 m/s: what is missing is a longer run to estimate it.
TEST(Certainty, ThatCannotBeTrustedYetIsNotSaidToBeTooSmall)
{
  SceneDefinition scene = layer(0.5);
  scene.duration = 4.0;
  Simulation brief(scene);
  ASSERT_LT(certaintyOf(brief).to_mean_vx->ratio.value_or(0.0), 1.0);
  const std::vector<std::string> warnings = runToEnd(brief, {}).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  const std::string start =
      "accuracy.mean_vx = 0.5 m/s was not reached within 4 s: the run is too short for a reliable error, "
      "over ";
  EXPECT_EQ(warnings[0].rfind(start, 0), 0u) << warnings[0];
  const std::string marker = "a duration of about ";
  const double told = std::stod(warnings[0].substr(warnings[0].find(marker) + marker.size()));
  scene.duration = 2.0 * told;
  Simulation longer(scene);
  EXPECT_EQ(runToEnd(longer, {}).end, RunEnd::ACCURATE);
}

TEST(Certainty, OfQThatCannotBeTrustedYetIsNotSaidToBeTooSmall)
{
  SceneDefinition scene = fedSieve(0.5);
  scene.duration = 4.0;
  Simulation brief(scene);
  const std::vector<std::string> warnings = runToEnd(brief, {}).warnings;
  ASSERT_LT(certaintyOf(brief).separation->estimate.half_width, 0.5);
  ASSERT_FALSE(warnings.empty());
  const std::string start =
      "accuracy.quality = 0.5 was not reached within 4 s: the run is too short for a reliable error, s = ";
  EXPECT_EQ(warnings.back().rfind(start, 0), 0u) << warnings.back();
}

TEST(Certainty, OfAMachineThatEmptiesIsNotSaidToTakeALongerRun)
{
  SceneDefinition scene = smallMixture();
  scene.duration = 5.0;
  scene.accuracy.mean_vx = 1e-6;
  Simulation simulation(scene);
  const std::vector<std::string> warnings = runToEnd(simulation, {}).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("the base runs empty, so a longer run does not help"), std::string::npos)
      << warnings[0];
}

TEST(Certainty, OfTheSeparationIsInTheSummaryOfAFedRunThatDidNotAskForIt)
{
  SceneDefinition scene = fedSieve(0.0);
  scene.duration = 60.0;
  Simulation simulation(scene);
  const auto json = summarize(simulation, runToEnd(simulation, {}));
  EXPECT_EQ(json["accuracy"]["separation"]["value"], json["separation"]);
  EXPECT_EQ(json["accuracy"]["quality"]["value"], json["quality"]);
  EXPECT_GT(json["accuracy"]["separation"]["half_width"], 0.0);
  EXPECT_EQ(json["accuracy"]["reached"], nullptr);
}

TEST(Certainty, OfQThatOnePourCannotGiveIsSaidWithTheRunsThatCould)
{
  SceneDefinition scene = smallMixture();
  scene.base.inclination = 0.3;
  scene.duration = 60.0;
  scene.accuracy.quality = 0.05;
  Simulation simulation(scene);
  const RunOutcome outcome = runToEnd(simulation, {});
  ASSERT_EQ(simulation.activeDisks(), 0u);
  EXPECT_EQ(outcome.end, RunEnd::COMPLETED);
  const Estimate quality = certaintyOf(simulation).separation->estimate;
  const double runs = std::ceil(std::pow(quality.half_width / 0.05, 2.0));
  ASSERT_EQ(outcome.warnings.size(), 1u);
  EXPECT_NE(outcome.warnings[0].find("; 0 disks have not left; about " + std::to_string(std::lround(runs)) +
                                     " runs with other seeds"),
            std::string::npos)
      << outcome.warnings[0];
}

TEST(Certainty, StandsInTheSummary)
{
  Simulation simulation(layer(0.01));
  const auto json = summarize(simulation, runToEnd(simulation, {}))["accuracy"];
  EXPECT_EQ(json["reached"], true);
  EXPECT_EQ(json["confidence"], 0.95);
  EXPECT_GE(json["transient"], 0.0);
  ASSERT_EQ(json["mean_vx"].size(), 2u);
  EXPECT_EQ(json["mean_vx"][1]["name"], "B");
  EXPECT_NEAR(json["mean_vx"][1]["value"].get<double>(), simulation.means()[1].mean_vx.value(), 0.01);
  EXPECT_LE(json["mean_vx"][1]["half_width"], 0.01);
  EXPECT_TRUE(json["quality"]["value"].is_null());
  EXPECT_TRUE(json["quality"]["half_width"].is_null());

  SceneDefinition unasked = ensemble(0.0);
  unasked.duration = 1.0;
  Simulation short_one(unasked);
  const auto nothing = summarize(short_one, runToEnd(short_one, {}))["accuracy"];
  EXPECT_TRUE(nothing["reached"].is_null());
  EXPECT_TRUE(nothing["transient"].is_null());
  EXPECT_TRUE(nothing["mean_vx"][0]["half_width"].is_null());
}

}  // namespace
}  // namespace ratchet_sieve
