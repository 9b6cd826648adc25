#include "ratchet_sieve/live/run_control.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "node_parameters.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "read_bags.h"
#include "recorder.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double CONTROL_STRIDE = 0.01;

NodeParameters pausedParameters()
{
  NodeParameters parameters;
  parameters.start_paused = true;
  return parameters;
}

/// A run of the small mixture under RunControl, without ROS.
class Controlled
{
public:
  /// @param watched whether somebody wants frames
  explicit Controlled(const std::string& bag = "", bool watched = true)
      : recorder(bag, "/sieve"),
        seen{watched},
        control(YAML::Load(canonicalYaml(smallMixture())), "scene", pausedParameters(), recorder)
  {
    recorder.open();
    control.addSink(seen);
    control.begin();
  }

  RunControl::Stride strides(double stride = CONTROL_STRIDE)
  {
    return [this, stride](double time)
    {
      control.advanceTo(std::min(time, control.run().time() + stride));
      return true;
    };
  }

  Outcome step(double duration, double stride = CONTROL_STRIDE)
  {
    return control.step(duration, strides(stride));
  }

  Outcome lockStep(const std::vector<std::pair<std::string, double>>& setpoints, double duration)
  {
    return control.lockStep(setpoints, duration, strides());
  }

  double time() const { return control.run().time(); }

  struct Sink : CollectingSink
  {
    explicit Sink(bool watched) : watched(watched) {}
    bool wants(FrameKind) const override { return watched; }
    bool watched;
  };

  NodeParameters parameters = pausedParameters();
  Recorder recorder;
  Sink seen;
  RunControl control;
};

std::vector<DiskState> disksAt(double time, const SceneDefinition& scene)
{
  Simulation simulation(scene);
  simulation.advanceTo(time);
  return makeParticleFrame(simulation).disks;
}

TEST(RunControl, recordsWhatNobodyElseWants)
{
  const ScratchDirectory scratch;
  Controlled run(scratch / "run.bag", false);
  EXPECT_TRUE(run.step(0.5).success);
  run.control.end();
  const CollectingSink recorded = readAll({scratch / "run.bag"});
  EXPECT_EQ(recorded.particles.size(), 6u);
  EXPECT_EQ(recorded.bins.size(), 31u);
  EXPECT_EQ(recorded.bases.size(), 31u);
  EXPECT_EQ(recorded.statistics.size(), 6u);
}

TEST(RunControl, stepsNoFurtherThanTheEndAndSaysSo)
{
  Controlled run;
  EXPECT_EQ(run.step(0.5).message, "");
  const Outcome outcome = run.step(4.0);
  EXPECT_TRUE(outcome.success);
  EXPECT_EQ(outcome.message, "the end of the run was reached at 2 s: 2.5 s of the step are left");
  EXPECT_TRUE(run.control.run().finished());
  EXPECT_EQ(run.time(), smallMixture().duration);
  EXPECT_EQ(run.step(1.0).message, "the scene's end is reached: reset first");
  run.control.reset(0, {}, false);
  EXPECT_EQ(run.lockStep({}, 2.5).message,
            "the end of the run was reached at 2 s: 0.5 s of the step are left");
}

/// In doubles, 0.1 + 0.1 + 0.1 is more than 0.3.
TEST(RunControl, isDoneWithAStepThatEndsWithTheScene)
{
  Controlled run;
  ASSERT_TRUE(run.control.reset(0, {"duration=0.3"}, false).success);
  for (int k = 0; k < 3; ++k)
    EXPECT_EQ(run.step(0.1).message, "");
  EXPECT_TRUE(run.control.run().finished());
}

TEST(RunControl, isFinishedByACollapseUntilItIsBegunAnew)
{
  Controlled run;
  ASSERT_TRUE(
      run.control.reset(0, {"contact.min_rebound_speed=0", "contact.collapse_events=10000"}, false).success);
  const Outcome outcome = run.step(2.0);
  EXPECT_FALSE(outcome.success);
  EXPECT_NE(outcome.message.find("inelastic collapse"), std::string::npos) << outcome.message;
  EXPECT_TRUE(run.control.run().finished());
  EXPECT_LT(run.time(), smallMixture().duration);
  EXPECT_EQ(run.seen.particles.back().time, run.time());
  EXPECT_EQ(run.step(1.0).message, outcome.message);
  ASSERT_TRUE(run.control.reset(0, {}, false).success);
  EXPECT_TRUE(run.step(1.0).success);
}

TEST(RunControl, refusesStepsThatMakeNoSense)
{
  Controlled run;
  EXPECT_FALSE(run.step(0.0).success);
  EXPECT_EQ(run.step(-1.0).message, "duration -1.000000 s: must be > 0 and finite");
  EXPECT_FALSE(run.step(std::numeric_limits<double>::quiet_NaN()).success);
  run.control.unpause();
  EXPECT_EQ(run.step(1.0).message, "the simulation is not paused: pause it first");
  EXPECT_EQ(run.time(), 0.0);
}

TEST(RunControl, interruptsALongStep)
{
  Controlled run;
  int strides = 0;
  const RunControl::Stride stride = run.strides();
  const auto three = [&](double time) { return ++strides <= 3 && stride(time); };
  const Outcome outcome = run.control.step(1.0, three);
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.message, "interrupted at 0.0266666667 s: 0.973333333 s of the step are left");
  EXPECT_EQ(run.seen.particles.back().time, run.time());
}

TEST(RunControl, resetsToTheSameRunOrToAnother)
{
  Controlled run;
  run.control.command(Quantity::INCLINATION, 0.3);
  run.step(0.5);
  EXPECT_TRUE(run.control.reset(0, {}, false).success);
  EXPECT_EQ(run.time(), 0.0);
  run.step(0.5);
  EXPECT_TRUE(sameBits(run.seen.particles.back().disks, disksAt(0.5, smallMixture())));

  EXPECT_TRUE(run.control.reset(5, {"base.inclination=0.1"}, false).success);
  SceneDefinition scene = smallMixture();
  scene.seed = 5;
  scene.base.inclination = 0.1;
  run.step(0.5);
  EXPECT_TRUE(sameBits(run.seen.particles.back().disks, disksAt(0.5, scene)));
  EXPECT_EQ(run.seen.scenes.back().seed, 5u);

  const Outcome outcome = run.control.reset(0, {"base.asymmetry=3"}, false);
  EXPECT_FALSE(outcome.success);
  EXPECT_NE(outcome.message.find("base.asymmetry"), std::string::npos) << outcome.message;
  EXPECT_EQ(run.time(), 0.5);
}

TEST(RunControl, poursTheDisksAnewWhileTimeAndBaseGoOn)
{
  Controlled run;
  run.control.command(Quantity::INCLINATION, 0.2);
  run.step(0.75);
  const BaseFrame before = run.control.run().now<BaseFrame>();
  EXPECT_TRUE(run.control.resetWorld().success);
  const BaseFrame after = run.control.run().now<BaseFrame>();
  EXPECT_EQ(after.time, 0.75);
  EXPECT_EQ(after.base.inclination, before.base.inclination);
  EXPECT_EQ(after.base.commanded_inclination, 0.2);
  EXPECT_NEAR(after.base.displacement, before.base.displacement, 1e-12);
  EXPECT_EQ(run.seen.particles.back().time, 0.75);
  EXPECT_EQ(run.seen.particles.back().disks.size(), 12u);
  run.step(0.5);
  EXPECT_EQ(run.seen.particles.back().time, 1.25);
  run.step(10.0, 10.0);
  EXPECT_EQ(run.time(), smallMixture().duration);
  // At the end, for another duration.
  EXPECT_TRUE(run.control.resetWorld().success);
  EXPECT_TRUE(run.step(100.0, 10.0).success);
  EXPECT_EQ(run.time(), 2.0 * smallMixture().duration);
}

TEST(RunControl, goesOnWhereTheBaseStandsInTheDisksToBePlacedAnew)
{
  const ScratchDirectory scratch;
  Controlled run(scratch / "run.bag");
  ASSERT_TRUE(run.control.reset(0, {"initial=[{species: A, x: 0.07, y: 0.0075}]"}, false).success);
  run.control.command(Quantity::INCLINATION, 0.1);
  run.step(1.5);
  const Outcome outcome = run.control.resetWorld();
  EXPECT_FALSE(outcome.success);
  EXPECT_EQ(outcome.message.rfind("initial.0 overlaps the base or a wall by ", 0), 0u) << outcome.message;
  const std::string end = ", with the base in its present position; the run continues";
  EXPECT_EQ(outcome.message.substr(outcome.message.size() - end.size()), end);

  // The same run, without an interruption in topics and recording.
  EXPECT_EQ(run.time(), 1.5);
  EXPECT_EQ(run.recorder.path(), scratch / "run_run2.bag");
  EXPECT_EQ(run.seen.scenes.size(), 2u);
  run.step(0.25);
  const auto seen = run.seen.particles.back();
  run.control.reset(0, {"initial=[{species: A, x: 0.07, y: 0.0075}]"}, false);
  run.control.command(Quantity::INCLINATION, 0.1);
  run.step(1.75);
  EXPECT_TRUE(sameBits(run.seen.particles.back(), seen));
}

TEST(RunControl, beginsAnewWhileTimeGoesOn)
{
  Controlled run;
  run.control.command(Quantity::INCLINATION, 0.2);
  run.step(0.75);
  EXPECT_TRUE(run.control.reset(0, {"base.inclination=0.1"}, true).success);
  EXPECT_EQ(run.time(), 0.75);
  EXPECT_EQ(run.seen.scenes.back().start_time, 0.75);
  EXPECT_EQ(run.seen.bases.back().base.inclination, 0.1);
  EXPECT_EQ(run.seen.bases.back().base.commanded_inclination, 0.1);
  run.step(100.0, 10.0);
  EXPECT_EQ(run.time(), 0.75 + smallMixture().duration);
}

TEST(RunControl, stepsInLockWithItsSetpoints)
{
  Controlled run;
  EXPECT_TRUE(run.lockStep({{"inclination", 0.1}, {"frequency", 30.0}}, 0.25).success);
  run.lockStep({{"inclination", 0.0}}, 0.25);
  Simulation simulation(smallMixture());
  simulation.setSlewRates(run.parameters.slew_rates);
  simulation.command(Quantity::INCLINATION, 0.1);
  simulation.command(Quantity::FREQUENCY, 30.0);
  simulation.advanceTo(0.25);
  simulation.command(Quantity::INCLINATION, 0.0);
  simulation.advanceTo(0.5);
  EXPECT_TRUE(sameBits(run.seen.particles.back().disks, makeParticleFrame(simulation).disks));
}

/// Its response contains statistics, even if nobody else wants them.
TEST(RunControl, observesPeriodsForALockStep)
{
  Controlled run("", false);
  ASSERT_TRUE(run.lockStep({}, 0.095).success);
  const StatisticsFrame first = run.control.run().now<StatisticsFrame>();
  EXPECT_EQ(first.window_start, 0.0);
  EXPECT_NEAR(first.window_end, 2.0 / smallMixture().base.frequency, 1e-9);
  ASSERT_TRUE(run.lockStep({}, 0.1).success);
  EXPECT_EQ(run.control.run().now<StatisticsFrame>().window_start, first.window_end);
}

TEST(RunControl, givesASetpointOfALockStepOnce)
{
  Controlled run;
  const std::size_t before = run.seen.commands.size();
  for (int k = 0; k < 5; ++k)
    ASSERT_TRUE(run.lockStep({{"inclination", 0.1}}, 0.05).success);
  EXPECT_EQ(run.seen.commands.size(), before + 1);
  ASSERT_TRUE(run.lockStep({{"inclination", 0.0}}, 0.05).success);
  EXPECT_EQ(run.seen.commands.size(), before + 2);
}

TEST(RunControl, takesAllSetpointsOfALockStepOrNone)
{
  Controlled run;
  const auto refusal = [&](const std::string& name, double value) {
    return run.lockStep({{"frequency", 30.0}, {name, value}}, 0.25).message;
  };
  EXPECT_EQ(refusal("inclination", 0.6),
            "inclination_setpoint 0.6 rad refused: must be from -0.5 to 0.5 rad");
  EXPECT_EQ(refusal("angle", 0.1), "setpoint angle: must be inclination, frequency or amplitude");
  EXPECT_EQ(run.time(), 0.0);
  EXPECT_EQ(run.control.run().now<BaseFrame>().base.commanded_frequency, smallMixture().base.frequency);
  run.control.unpause();
  EXPECT_EQ(refusal("inclination", 0.1), "the simulation is not paused: pause it first");
}

TEST(RunControl, poursMoreOn)
{
  Controlled run;
  EXPECT_TRUE(run.control.pour("B", 3).success);
  EXPECT_EQ(run.seen.bins.back().bins[1].on_base, 9u);
  EXPECT_TRUE(run.control.pour("B", 1, Stretch{0.0, 0.01}).success);
  EXPECT_FALSE(run.control.pour("B", 1, Stretch{0.01, 0.0}).success);
  EXPECT_EQ(run.seen.bins.back().bins[1].on_base, 10u);
  EXPECT_EQ(run.control.pour("C\n", 1).message, "species C : there is none of that name");
  EXPECT_EQ(run.control.pour("B", 4000000000).message, "count 4000000000: must be from 1 to 10000");
}
}  // namespace
}  // namespace ratchet_sieve
