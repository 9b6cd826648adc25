#include <algorithm>
#include <future>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/LockStep.h"
#include "ratchet_sieve/PourDisks.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "read_bags.h"
#include "started_node.h"

namespace ratchet_sieve
{
namespace
{
/// Long enough to be interrupted, short enough that a failing test ends [s].
constexpr double LONG = 2000.0;

constexpr double STEP = 0.05;   // s
constexpr double WINDOW = 0.5;  // s

/// A paused sieve with a long scene, which records as fast as possible.
class Command : public testing::Test
{
protected:
  /// Calls a service that advances by LONG, and returns when the step has begun.
  template <typename Service>
  std::future<typename Service::Response> underWay(const std::string& name)
  {
    auto answer = std::async(std::launch::async,
                             [path = sieve_.node.resolveName(name)]
                             {
                               Service service;
                               service.request.duration = LONG;
                               EXPECT_TRUE(ros::service::call(path, service));
                               return service.response;
                             });
    EXPECT_TRUE(waitFor([this] { return sieve_.base.frames.back().time > 0.0; }));
    return answer;
  }

  template <typename Response>
  static void expectInterrupted(const Response& answer)
  {
    EXPECT_FALSE(answer.success);
    EXPECT_EQ(answer.message.rfind("interrupted at ", 0), 0u) << answer.message;
    EXPECT_GT(answer.time, 0.0);
    EXPECT_LT(answer.time, LONG);
  }

  /// Checks that the time is the one that the step reached, and that the next step continues from there.
  void expectToGoOnFrom(double time)
  {
    ASSERT_TRUE(sieve_.particles.waitForTime(time));
    sieve_.stepAndSee(0.1);
    EXPECT_EQ(sieve_.base.frames.back().time, time + 0.1);
  }

  std::string bag(const std::string& name = "run.bag") const { return scratch_ / name; }

  static int resimulate(const std::string& path) { return ChildNode("sieve_resimulate", {path}).wait(); }

  ScratchDirectory scratch_;
  StartedNode started_{"/busy",
                       {{"scene/duration", LONG},
                        {"record", bag()},
                        {"real_time_factor", 0.0},
                        {"window", WINDOW},
                        {"limits/inclination/slew_rate", 0.4}}};
  SieveClient& sieve_ = started_.sieve;
};

TEST_F(Command, aLongStepGivesWayToAPause)
{
  auto step = underWay<StepSimulation>("step");
  ASSERT_TRUE(sieve_.call("pause_physics"));
  const StepSimulation::Response answer = step.get();
  expectInterrupted(answer);
  expectToGoOnFrom(answer.time);
}

TEST_F(Command, aLongLockStepGivesWayToAReset)
{
  auto step = underWay<LockStep>("lock_step");
  const ResetSimulation::Response reset = sieve_.reset();
  EXPECT_TRUE(reset.success) << reset.message;
  const LockStep::Response answer = step.get();
  expectInterrupted(answer);
  EXPECT_FALSE(answer.finished);
  ASSERT_TRUE(sieve_.base.waitForTime(0.0));
  expectToGoOnFrom(0.0);
}

TEST_F(Command, aSetpointDoesNotInterruptAStep)
{
  auto step = underWay<StepSimulation>("step");
  sieve_.publish("inclination", 0.125);
  const double before = sieve_.base.frames.back().time;
  ASSERT_TRUE(waitFor([&] { return sieve_.base.frames.back().time > before + 10.0; }));
  EXPECT_EQ(sieve_.commanded("inclination"), 0.0);
  ASSERT_TRUE(sieve_.call("reset_world"));
  expectInterrupted(step.get());
  EXPECT_TRUE(waitFor([&] { return sieve_.commanded("inclination") == 0.125; }));
}

TEST_F(Command, aLongStepGivesWayToTheEndOfTheNode)
{
  auto step = underWay<StepSimulation>("step");
  EXPECT_EQ(started_.end(), 0) << started_.node->errors();
  step.wait();
  EXPECT_GT(readAll({bag()}).particles.back().time, 0.0);
}

TEST_F(Command, ofTwoNodesOfOneNameTheFirstEndsItsRecordingWell)
{
  sieve_.stepAndSee(1.25);
  const ParticleFrame last = sieve_.particles.frames.back();
  ros::param::set("/busy/record", bag("second.bag"));
  sieve_.scene.forget();
  ChildNode second("sieve_node", {"__name:=busy"});
  EXPECT_EQ(started_.node->wait(), 0) << started_.node->errors();
  EXPECT_TRUE(sameBits(readAll({bag()}).particles.back(), last));

  sieve_.forget();
  ASSERT_TRUE(sieve_.connect());
  sieve_.stepAndSee(0.5);
  second.interrupt(SIGHUP);
  EXPECT_EQ(second.wait(), 0) << second.errors();
  EXPECT_EQ(readAll({bag("second.bag")}).particles.back().time, 0.5);
}

TEST_F(Command, aRunIsGivenAgainBitForBit)
{
  ASSERT_TRUE(sieve_.call("unpause_physics"));
  sieve_.command("inclination", 0.1);
  sieve_.command("frequency", 25.0);
  PourDisks pour;
  pour.request.species = "A";
  pour.request.count = 5;
  ASSERT_TRUE(ros::service::call("/busy/pour", pour));
  EXPECT_TRUE(pour.response.success);
  sieve_.command("amplitude", 0.0015);
  ASSERT_TRUE(sieve_.call("pause_physics"));
  sieve_.stepAndSee(0.123);
  ASSERT_TRUE(sieve_.call("unpause_physics"));
  sieve_.command("inclination", -0.05);
  ASSERT_TRUE(sieve_.call("reset_world"));
  sieve_.command("inclination", 0.02);
  ASSERT_TRUE(sieve_.reset(3, {"base.inclination=0.05"}, true).success);
  sieve_.command("frequency", 20.0);
  EXPECT_EQ(started_.end(), 0) << started_.node->errors();
  for (const char* name : {"run.bag", "run_run2.bag", "run_run3.bag"})
    EXPECT_EQ(resimulate(bag(name)), 0) << name;
  ChildNode filter("/usr/bin/env",
                   {"rosbag", "filter", bag(), bag("without.bag"), "topic != '/busy/commands'"});
  ASSERT_EQ(filter.wait(), 0) << filter.errors();
  EXPECT_EQ(resimulate(bag("without.bag")), 1);
  EXPECT_EQ(resimulate(bag("nowhere.bag")), 1);
}

/// A controller that tilts to the side on which more disks have left, in lock step. @return its responses
std::vector<LockStep::Response> controlledRun(SieveClient& sieve, std::uint64_t seed)
{
  EXPECT_TRUE(sieve.reset(seed).success);
  // One connection for all steps, as a real controller would use.
  ros::ServiceClient lock_step = sieve.node.serviceClient<LockStep>("lock_step", true);
  LockStep step;
  step.request.duration = STEP;
  std::vector<LockStep::Response> responses;
  for (int k = 0; k < 40; ++k)
  {
    EXPECT_TRUE(lock_step.call(step));
    EXPECT_TRUE(step.response.success) << step.response.message;
    BaseSetpoint setpoint;
    setpoint.quantity = "inclination";
    setpoint.value = step.response.bins.left.at(0) > step.response.bins.right.at(0) ? 0.1 : -0.1;
    step.request.setpoints = {setpoint};
    responses.push_back(step.response);
  }
  return responses;
}

TEST_F(Command, inLockStepAControllerRunsTheSameEachTimeAndIsToldWhatLeftLately)
{
  const std::vector<LockStep::Response> run = controlledRun(sieve_, 5);
  const LockStep::Response &first = run.back(), second = controlledRun(sieve_, 5).back(),
                           other = controlledRun(sieve_, 6).back();
  EXPECT_NEAR(first.time, 2.0, 1e-12);
  EXPECT_NE(first.base.inclination, 0.0);
  EXPECT_TRUE(sameBits(toFrame(first.base), toFrame(second.base)));
  EXPECT_TRUE(sameBits(toFrame(first.bins), toFrame(second.bins)));
  EXPECT_TRUE(sameBits(toFrame(first.statistics).species, toFrame(second.statistics).species));
  EXPECT_FALSE(sameBits(toFrame(first.statistics).species, toFrame(other.statistics).species));

  const auto steps = static_cast<std::size_t>(WINDOW / STEP);
  std::uint64_t most = 0;
  for (std::size_t k = steps; k < run.size(); ++k)
  {
    const BinCounts &now = run[k].bins, &before = run[k - steps].bins;
    EXPECT_EQ(now.window_start, now.time - WINDOW);
    for (std::size_t s = 0; s < now.species.size(); ++s)
    {
      EXPECT_EQ(now.window_left.at(s), now.left[s] - before.left[s]);
      EXPECT_EQ(now.window_right.at(s), now.right[s] - before.right[s]);
      most = std::max(most, now.window_left[s]);
    }
  }
  EXPECT_GT(most, 0u);
  EXPECT_EQ(run.front().bins.window_start, 0.0);
}
}  // namespace
}  // namespace ratchet_sieve
