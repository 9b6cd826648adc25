#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "child_node.h"
#include "ratchet_sieve/LockStep.h"
#include "ratchet_sieve/PourDisks.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Starts nodes that record, as fast as possible; the scene is on the parameter server.
class Resimulate : public testing::Test
{
protected:
  void prepare(const std::string& name)
  {
    XmlRpc::XmlRpcValue scene;
    ASSERT_TRUE(ros::param::get("/scene", scene));
    scene["duration"] = 1000.0;
    ros::param::set(name + "/scene", scene);
    ros::param::set(name + "/record", bag());
    ros::param::set(name + "/real_time_factor", 0.0);
    ros::param::set(name + "/start_paused", true);
    ros::param::set(name + "/limits/inclination/slew_rate", 0.4);
  }

  static std::vector<std::string> named(const std::string& name) { return {"__name:=" + name}; }

  std::string bag(const std::string& name = "run.bag") const { return scratch_ / name; }

  static int resimulate(const std::string& path)
  {
    ChildNode program("sieve_resimulate", {path});
    return program.wait();
  }

  ScratchDirectory scratch_;
};

/// Commands during the run, and waits until the sieve shows the setpoint.
void commandWhileItRuns(SieveClient& sieve, const std::string& quantity, double value,
                        double DriveState::*commanded)
{
  sieve.publish(quantity, value);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.*commanded == value; }));
}

TEST_F(Resimulate, givesARunUnderCommandAgainBitForBit)
{
  prepare("/commanded");
  ChildNode node("sieve_node", named("commanded"));
  SieveClient sieve("/commanded");
  ASSERT_TRUE(sieve.connect());
  ASSERT_TRUE(sieve.call("unpause_physics"));
  commandWhileItRuns(sieve, "inclination", 0.1, &DriveState::commanded_inclination);
  commandWhileItRuns(sieve, "frequency", 25.0, &DriveState::commanded_frequency);
  PourDisks pour;
  pour.request.species = "A";
  pour.request.count = 5;
  ASSERT_TRUE(ros::service::call("/commanded/pour", pour));
  commandWhileItRuns(sieve, "amplitude", 0.0015, &DriveState::commanded_amplitude);
  ASSERT_TRUE(sieve.call("pause_physics"));
  sieve.stepAndSee(0.123);
  ASSERT_TRUE(sieve.call("unpause_physics"));
  commandWhileItRuns(sieve, "inclination", -0.05, &DriveState::commanded_inclination);
  ASSERT_TRUE(sieve.call("reset_world"));
  commandWhileItRuns(sieve, "inclination", 0.02, &DriveState::commanded_inclination);
  ASSERT_TRUE(sieve.reset(3, {"base.inclination=0.05"}, true).success);
  commandWhileItRuns(sieve, "frequency", 20.0, &DriveState::commanded_frequency);
  node.interrupt();
  EXPECT_EQ(node.wait(), 0) << node.errors();
  for (const char* name : {"run.bag", "run_run2.bag", "run_run3.bag"})
    EXPECT_EQ(resimulate(bag(name)), 0) << name;
}

/// Copies a bag without the messages of one topic.
void copyWithout(const std::string& topic, const std::string& from, const std::string& to)
{
  rosbag::Bag source(from);
  rosbag::Bag copy(to, rosbag::bagmode::Write);
  for (const rosbag::MessageInstance& message : rosbag::View(source))
    if (message.getTopic() != topic)
      copy.write(message.getTopic(), message.getTime(), message);
}

TEST_F(Resimulate, saysThatSomethingIsMissing)
{
  prepare("/whole");
  ChildNode node("sieve_node", named("whole"));
  SieveClient sieve("/whole");
  ASSERT_TRUE(sieve.connect());
  sieve.stepAndSee(0.5);
  commandWhileItRuns(sieve, "inclination", 0.1, &DriveState::commanded_inclination);
  sieve.stepAndSee(0.5);
  node.interrupt();
  ASSERT_EQ(node.wait(), 0) << node.errors();
  copyWithout("/whole/commands", bag(), bag("without.bag"));
  EXPECT_EQ(resimulate(bag()), 0);
  EXPECT_EQ(resimulate(bag("without.bag")), 1);
  EXPECT_EQ(resimulate(bag("nowhere.bag")), 1);
}

/// A controller that tilts to the side on which more disks have left, in lock step. @return its last response
LockStep::Response controlledRun(const std::string& sieve, std::uint64_t seed)
{
  ResetSimulation reset;
  reset.request.seed = seed;
  EXPECT_TRUE(ros::service::call(sieve + "/reset", reset));
  // One connection for all steps, as a real controller would use.
  ros::ServiceClient lock_step = ros::NodeHandle().serviceClient<LockStep>(sieve + "/lock_step", true);
  LockStep step;
  step.request.duration = 0.05;
  for (int k = 0; k < 40; ++k)
  {
    EXPECT_TRUE(lock_step.call(step));
    EXPECT_TRUE(step.response.success) << step.response.message;
    const BinCounts& bins = step.response.bins;
    BaseSetpoint setpoint;
    setpoint.quantity = "inclination";
    setpoint.value = bins.left.at(0) > bins.right.at(0) ? 0.1 : -0.1;
    step.request.setpoints = {setpoint};
  }
  return step.response;
}

TEST_F(Resimulate, runsInLockStepWithAControllerTheSameEachTime)
{
  prepare("/locked");
  ChildNode node("sieve_node", named("locked"));
  SieveClient sieve("/locked");
  ASSERT_TRUE(sieve.connect());
  const LockStep::Response first = controlledRun("/locked", 5);
  const LockStep::Response second = controlledRun("/locked", 5);
  const LockStep::Response other = controlledRun("/locked", 6);
  EXPECT_NEAR(first.time, 2.0, 1e-12);
  EXPECT_NE(first.base.inclination, 0.0);
  EXPECT_TRUE(sameBits(toFrame(first.base), toFrame(second.base)));
  EXPECT_TRUE(sameBits(toFrame(first.bins), toFrame(second.bins)));
  EXPECT_TRUE(sameBits(toFrame(first.statistics).species, toFrame(second.statistics).species));
  EXPECT_FALSE(sameBits(toFrame(first.statistics).species, toFrame(other.statistics).species));
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "resimulate_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
