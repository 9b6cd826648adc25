#include <cstdlib>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "child_node.h"
#include "collecting_sink.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Starts and stops nodes itself. The scene is on the parameter server, under each node's name.
class Record : public testing::Test
{
protected:
  /// Parameters of a node of this name, which records into bag().
  void prepare(const std::string& name, double real_time_factor, bool start_paused)
  {
    XmlRpc::XmlRpcValue scene;
    ASSERT_TRUE(ros::param::get("/scene", scene));
    ros::param::set(name + "/scene", scene);
    ros::param::set(name + "/record", bag());
    ros::param::set(name + "/real_time_factor", real_time_factor);
    ros::param::set(name + "/start_paused", start_paused);
  }

  std::string bag() const { return scratch_ / "run.bag"; }

  static std::vector<std::string> named(const std::string& name) { return {"__name:=" + name}; }

  ScratchDirectory scratch_;
};

TEST_F(Record, holdsTheFirstAndTheLastMessageWhenInterrupted)
{
  prepare("/interrupted", 1.0, true);
  ChildNode node("sieve_node", named("interrupted"));
  SieveClient sieve("/interrupted");
  ASSERT_TRUE(sieve.connect());
  sieve.stepAndSee(1.5);
  sieve.publish("inclination", 0.125);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.125; }));
  sieve.stepAndSee(0.9876);
  node.interrupt();
  EXPECT_EQ(node.wait(), 0) << node.errors();

  EXPECT_FALSE(std::filesystem::exists(bag() + ".active"));
  CollectingSink recorded;
  readBag(bag(), recorded);
  EXPECT_EQ(recorded.particles.front().time, 0.0);
  EXPECT_EQ(recorded.particles.back().time, 2.4876);
  EXPECT_TRUE(sameBits(recorded.particles.back(), sieve.particles.frames.back()));
  EXPECT_TRUE(sameBits(recorded.bins.back(), sieve.bins.frames.back()));
  EXPECT_TRUE(sameBits(recorded.statistics.back(), sieve.statistics.frames.back()));
  ASSERT_TRUE(recorded.bins.back().quality);
  EXPECT_EQ(recorded.bins.back().quality, sieve.bins.frames.back().quality);
  EXPECT_EQ(recorded.bins.back().processed, sieve.bins.frames.back().processed);

  rosbag::Bag file(bag());
  rosbag::View all(file);
  rosbag::View scenes(file, rosbag::TopicQuery("/interrupted/scene"));
  EXPECT_EQ(scenes.getBeginTime(), all.getBeginTime());
  rosbag::View setpoints(file, rosbag::TopicQuery("/interrupted/inclination_setpoint"));
  ASSERT_EQ(setpoints.size(), 1u);
  EXPECT_EQ(setpoints.begin()->getTime(), ros::Time(1.5));
  EXPECT_EQ(setpoints.begin()->instantiate<std_msgs::Float64>()->data, 0.125);
  EXPECT_EQ(std::system(("rosbag check " + bag()).c_str()), 0);
}

TEST_F(Record, endsWithTheSceneAndClosesTheBag)
{
  prepare("/finishing", 0.0, true);
  ChildNode node("sieve_node", named("finishing"));
  SieveClient sieve("/finishing");
  ASSERT_TRUE(sieve.connect());
  ASSERT_TRUE(sieve.call("unpause_physics"));
  EXPECT_EQ(node.wait(), 0) << node.errors();

  ASSERT_TRUE(sieve.bins.waitForTime(20.0));
  CollectingSink recorded;
  readBag(bag(), recorded);
  EXPECT_EQ(recorded.bins.size(), 20u * 60u + 1u);
  EXPECT_TRUE(sameBits(recorded.bins.back(), sieve.bins.frames.back()));
  EXPECT_TRUE(recorded.bins.back().quality);
}

TEST_F(Record, refusesABadSceneWithOneLine)
{
  prepare("/bad", 1.0, true);
  ros::param::set("/bad/scene/base/asymmetry", 3.0);
  ChildNode node("sieve_node", named("bad"));
  EXPECT_EQ(node.wait(), 2);
  EXPECT_EQ(node.errors().rfind("sieve_node: parameter /bad/scene", 0), 0u) << node.errors();
  EXPECT_NE(node.errors().find("base.asymmetry"), std::string::npos) << node.errors();
  EXPECT_EQ(node.errors().find('\n'), node.errors().size() - 1) << node.errors();
  EXPECT_TRUE(scratch_.empty());
}

TEST_F(Record, refusesABadParameterWithOneLine)
{
  prepare("/odd", 1.0, true);
  ros::param::set("/odd/rates/base", -1.0);
  ChildNode node("sieve_node", named("odd"));
  EXPECT_EQ(node.wait(), 2);
  EXPECT_EQ(node.errors(), "sieve_node: parameter /odd/rates/base: -1: must be a number from 0 to 100000\n");
  EXPECT_TRUE(scratch_.empty());
}

TEST_F(Record, refusesABagThatCannotBeWritten)
{
  prepare("/unwritable", 1.0, true);
  ros::param::set("/unwritable/record", scratch_ / "nowhere/run.bag");
  ChildNode node("sieve_node", named("unwritable"));
  EXPECT_EQ(node.wait(), 2);
  EXPECT_NE(node.errors().find("nowhere/run.bag: cannot be written"), std::string::npos) << node.errors();
}

TEST_F(Record, helpsWithoutBeingANode)
{
  for (const char* program : {"sieve_display", "sieve_node", "sieve_rviz", "sieve_schedule"})
    for (const char* option : {"--help", "--version"})
    {
      ChildNode node(program, {option});
      EXPECT_EQ(node.wait(), 0) << program << " " << option;
    }
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "record_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
