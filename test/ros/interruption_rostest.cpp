#include <future>

#include <gtest/gtest.h>

#include "child_node.h"
#include "collecting_sink.h"
#include "ratchet_sieve/LockStep.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Long enough to be interrupted, short enough that a failing test ends [s].
constexpr double LONG = 2000.0;

/// A paused sieve with a long scene, which records.
class Interruption : public testing::Test
{
protected:
  void SetUp() override
  {
    XmlRpc::XmlRpcValue scene;
    ASSERT_TRUE(ros::param::get("/scene", scene));
    scene["duration"] = LONG;
    ros::param::set("/busy/scene", scene);
    ros::param::set("/busy/start_paused", true);
    ros::param::set("/busy/exit_at_end", false);
    ros::param::set("/busy/record", bag());
    node_ = std::make_unique<ChildNode>("sieve_node", NAMED);
    ASSERT_TRUE(sieve_.connect());
  }

  std::string bag() const { return scratch_ / "run.bag"; }

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

  const std::vector<std::string> NAMED{"__name:=busy"};
  ScratchDirectory scratch_;
  SieveClient sieve_{"/busy"};
  std::unique_ptr<ChildNode> node_;
};

TEST_F(Interruption, aLongStepGivesWayToAPause)
{
  auto step = underWay<StepSimulation>("step");
  ASSERT_TRUE(sieve_.call("pause_physics"));
  const StepSimulation::Response answer = step.get();
  expectInterrupted(answer);
  expectToGoOnFrom(answer.time);
}

TEST_F(Interruption, aLongLockStepGivesWayToAReset)
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

TEST_F(Interruption, aSetpointDoesNotInterruptAStep)
{
  auto step = underWay<StepSimulation>("step");
  sieve_.publish("inclination", 0.125);
  const double before = sieve_.base.frames.back().time;
  ASSERT_TRUE(waitFor([&] { return sieve_.base.frames.back().time > before + 10.0; }));
  EXPECT_EQ(sieve_.base.frames.back().base.commanded_inclination, 0.0);
  ASSERT_TRUE(sieve_.call("reset_world"));
  expectInterrupted(step.get());
  EXPECT_TRUE(waitFor([&] { return sieve_.base.frames.back().base.commanded_inclination == 0.125; }));
}

TEST_F(Interruption, aLongStepGivesWayToTheEndOfTheNode)
{
  auto step = underWay<StepSimulation>("step");
  node_->interrupt();
  EXPECT_EQ(node_->wait(), 0) << node_->errors();
  step.wait();
  CollectingSink recorded;
  readBag(bag(), recorded);
  EXPECT_GT(recorded.particles.back().time, 0.0);
}

TEST_F(Interruption, ofTwoNodesOfOneNameTheFirstEndsItsRecordingWell)
{
  sieve_.stepAndSee(1.25);
  const ParticleFrame last = sieve_.particles.frames.back();
  ros::param::set("/busy/record", scratch_ / "second.bag");
  sieve_.scene.forget();
  ChildNode second("sieve_node", NAMED);
  EXPECT_EQ(node_->wait(), 0) << node_->errors();
  CollectingSink recorded;
  readBag(bag(), recorded);
  EXPECT_TRUE(sameBits(recorded.particles.back(), last));

  sieve_.forget();
  ASSERT_TRUE(sieve_.connect());
  sieve_.stepAndSee(0.5);
  second.interrupt(SIGHUP);
  EXPECT_EQ(second.wait(), 0) << second.errors();
  CollectingSink of_second;
  readBag(scratch_ / "second.bag", of_second);
  EXPECT_EQ(of_second.particles.back().time, 0.5);
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "interruption_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
