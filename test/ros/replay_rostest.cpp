#include <algorithm>
#include <map>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>
#include <nlohmann/json.hpp>

#include "child_node.h"
#include "collecting_sink.h"
#include "own_master.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "ratchet_sieve/ros/transform_publisher.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
std::string bag_path;  // given by roslaunch to replay.launch and to this test

/// The frames of one complete pass over the bag: from one jump back in time to the next; none before two
/// jumps.
template <typename Frame>
std::vector<Frame> wholePass(const std::vector<Frame>& frames)
{
  const auto jumps_back = [](const Frame& a, const Frame& b) { return b.time < a.time; };
  const auto before = std::adjacent_find(frames.begin(), frames.end(), jumps_back);
  if (before == frames.end())
    return {};
  const auto last = std::adjacent_find(std::next(before), frames.end(), jumps_back);
  return last == frames.end() ? std::vector<Frame>() : std::vector<Frame>(std::next(before), std::next(last));
}

/// The bag is played repeatedly by replay.launch; no simulation runs.
class Replay : public testing::Test
{
protected:
  Replay() { readBag(bag_path, recorded); }

  template <typename Message, typename Frame>
  std::vector<Frame> replayed(const std::string& name, const std::vector<Frame>& all)
  {
    Topic<Message> topic;
    topic.subscribe(node, "/sieve/" + name);
    EXPECT_TRUE(waitFor([&] { return !wholePass(topic.frames).empty(); })) << name;
    std::vector<Frame> pass = wholePass(topic.frames);
    EXPECT_TRUE(sameBits(pass, all)) << name << ": " << pass.size() << " of " << all.size();
    return pass;
  }

  ros::NodeHandle node;
  CollectingSink recorded;
};

TEST_F(Replay, bringsEveryFrameBitForBit)
{
  replayed<ParticleStates>("particles", recorded.particles);
  replayed<BaseState>("base", recorded.bases);
  replayed<SieveStatistics>("statistics", recorded.statistics);
}

TEST_F(Replay, givesTheQualityAndCountsThatTheBagGives)
{
  const ScratchDirectory scratch;
  ChildNode analysis("sieve_analyze", {bag_path, "--summary", scratch / "summary.json"});
  ASSERT_EQ(analysis.wait(), 0) << analysis.errors();
  const auto offline = nlohmann::json::parse(contents(scratch / "summary.json"));

  const auto pass = replayed<BinCounts>("bins", recorded.bins);
  ASSERT_FALSE(pass.empty());
  const BinFrame& last = pass.back();
  ASSERT_TRUE(last.quality && last.processed);
  EXPECT_TRUE(sameBits(*last.quality, offline["quality"].get<double>()));
  EXPECT_TRUE(sameBits(*last.processed, offline["processed"].get<double>()));
  ASSERT_EQ(offline["species"].size(), last.species.size());
  for (std::size_t k = 0; k < last.species.size(); ++k)
  {
    const auto& species = offline["species"][k];
    EXPECT_EQ(species["name"], last.species[k]);
    EXPECT_EQ(species["left"], last.bins[k].left);
    EXPECT_EQ(species["right"], last.bins[k].right);
    EXPECT_EQ(species["on_base"], last.bins[k].on_base);
  }
}

TEST_F(Replay, bringsTheSceneAlsoToThoseWhoComeLate)
{
  rosbag::Bag bag(bag_path);
  for (const rosbag::ConnectionInfo* connection :
       rosbag::View(bag, rosbag::TopicQuery("/sieve/scene")).getConnections())
    EXPECT_EQ((*connection->header)["latching"], "1");
  Topic<SceneDescription> scene;
  scene.subscribe(node, "/sieve/scene");
  ASSERT_TRUE(waitFor([&] { return !scene.frames.empty(); }));
  EXPECT_TRUE(sameBits(scene.frames.back(), recorded.scenes.at(0)));
}

/// The positions of the disks of a species, as drawn and as recorded.
std::vector<geometry_msgs::Point> places(const ParticleFrame& frame, std::uint32_t species)
{
  std::vector<geometry_msgs::Point> points;
  for (const DiskState& disk : frame.disks)
  {
    if (disk.species != species)
      continue;
    geometry_msgs::Point point;
    point.x = disk.x;
    point.z = disk.y;
    points.push_back(point);
  }
  return points;
}

TEST_F(Replay, isShownAsItWasRecordedAlsoWhenTimeJumpsBack)
{
  std::map<ros::Time, const ParticleFrame*> at;
  for (const ParticleFrame& frame : recorded.particles)
    at[stampOf(frame.time)] = &frame;
  std::vector<ros::Time> stamps;
  std::size_t wrong = 0;
  const auto look = [&](const visualization_msgs::MarkerArray::ConstPtr& picture)
  {
    for (const auto& marker : picture->markers)
    {
      if (marker.ns != "disks" || marker.action != visualization_msgs::Marker::ADD)
        continue;
      stamps.push_back(marker.header.stamp);
      const auto found = at.find(marker.header.stamp);
      if (found == at.end() || marker.points != places(*found->second, static_cast<std::uint32_t>(marker.id)))
        ++wrong;
    }
  };
  const ros::Subscriber markers =
      node.subscribe<visualization_msgs::MarkerArray>("/sieve_display/markers", 1000, look);
  // Two jumps back to the beginning, and further frames.
  const auto jumps = [&]
  {
    std::size_t count = 0;
    for (std::size_t k = 1; k < stamps.size(); ++k)
      count += stamps[k] < stamps[k - 1] ? 1 : 0;
    return count;
  };
  ASSERT_TRUE(waitFor([&] { return jumps() >= 2 && stamps.back() > ros::Time(1.0); }));
  EXPECT_EQ(wrong, 0u);
}

TEST_F(Replay, movesTheTransforms)
{
  std::map<ros::Time, std::vector<geometry_msgs::TransformStamped>> expected;
  for (const BaseFrame& frame : recorded.bases)
    expected[stampOf(frame.time)] = baseTransforms(frame);
  std::size_t seen = 0, right = 0;
  const ros::Subscriber transforms = node.subscribe<tf2_msgs::TFMessage>(
      "/tf", 1000,
      [&](const tf2_msgs::TFMessage::ConstPtr& message)
      {
        ++seen;
        const auto found = expected.find(message->transforms.at(0).header.stamp);
        right += found != expected.end() && found->second == message->transforms ? 1 : 0;
      });
  ASSERT_TRUE(waitFor([&] { return seen >= 100; }));
  EXPECT_EQ(right, seen);
}

TEST_F(Replay, endsItsLaunchWhereTheBagCannotBePlayed)
{
  const ScratchDirectory scratch;
  const std::string whole = contents(bag_path);
  std::ofstream(scratch / "cut.bag", std::ios::binary) << whole.substr(0, whole.size() / 2);
  for (const std::string name : {"missing.bag", "cut.bag"})
  {
    ChildNode launch("/usr/bin/env", {"roslaunch", "-p", std::to_string(freePort()), "ratchet_sieve",
                                      "replay.launch", "rviz:=false", "bag:=" + (scratch / name)});
    launch.wait();
    EXPECT_NE(launch.errors().find(name), std::string::npos) << launch.errors();
  }
}

/// Its name differs from the requested one.
TEST_F(Replay, isMissedByADisplayOfAnotherSieve)
{
  ChildNode display("sieve_display", {"__name:=other_display", "_sieve:=/s1"});
  EXPECT_TRUE(
      display.waitForError("nothing to show: no scene of /s1 yet; there is /sieve, to be named in the "
                           "parameter ~sieve"));
}

TEST_F(Replay, isShownByADisplayThatComesLate)
{
  ChildNode late("sieve_display", {"__name:=late"});
  sensor_msgs::PointCloud2::ConstPtr last;
  const ros::Subscriber cloud = node.subscribe<sensor_msgs::PointCloud2>(
      "/late/cloud", 10, [&](const sensor_msgs::PointCloud2::ConstPtr& message) { last = message; });
  ASSERT_TRUE(waitFor([&] { return last && last->width > 0; }));
  late.interrupt();
  EXPECT_EQ(late.wait(), 0);
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "replay_rostest");
  if (argc < 2)
    return 2;
  ratchet_sieve::bag_path = argv[1];
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
