// A profile, disks of several sizes and a drive that turns with the base, as a user of ROS sees them.
#include <algorithm>
#include <memory>
#include <numeric>

#include <gtest/gtest.h>
#include <visualization_msgs/MarkerArray.h>

#include "child_node.h"
#include "collecting_sink.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// A node that records, paused, and the same run without ROS.
class Profile : public testing::Test
{
protected:
  void SetUp() override
  {
    ros::param::set("/deck/record", bag());
    ros::param::set("/deck/start_paused", true);
    node_ = std::make_unique<ChildNode>("sieve_node", std::vector<std::string>{"__name:=deck"});
    sieve_ = std::make_unique<SieveClient>("/deck");
    ASSERT_TRUE(sieve_->connect());
  }

  static SceneDefinition scene()
  {
    std::string path;
    EXPECT_TRUE(ros::param::get("/scene_file", path));
    return loadSceneFile(path).definition;
  }

  std::string bag() const { return scratch_ / "run.bag"; }

  ScratchDirectory scratch_;
  std::unique_ptr<ChildNode> node_;
  std::unique_ptr<SieveClient> sieve_;
};

std::uint64_t sumOf(const std::vector<std::uint64_t>& counts)
{
  return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
}

TEST_F(Profile, IsTheSameRunAsWithoutROS)
{
  sieve_->stepAndSee(0.7);
  sieve_->stepAndSee(0.81);
  Simulation simulation(scene());
  simulation.advanceTo(0.7);
  simulation.advanceTo(sieve_->base.frames.back().time);
  EXPECT_TRUE(sameBits(sieve_->base.frames.back(), makeBaseFrame(simulation)));
  EXPECT_NE(sieve_->base.frames.back().base.horizontal_displacement, 0.0);  // of an inclined deck
  EXPECT_TRUE(sameBits(sieve_->bins.frames.back(), makeBinFrame(simulation)));
  EXPECT_TRUE(sameBits(sieve_->particles.frames.back(), makeParticleFrame(simulation)));
  EXPECT_NE(sieve_->particles.frames.back().disks[0].radius, 0.0);

  const StatisticsFrame& statistics = sieve_->statistics.frames.back();
  const FaceContacts expected = simulation.faceContacts();
  EXPECT_EQ(statistics.faces.face_contacts, expected.face_contacts);
  EXPECT_EQ(statistics.faces.corner_contacts, expected.corner_contacts);
  ASSERT_EQ(statistics.faces.face_contacts.size(), 6u);
  const CollisionCounts& kinds = statistics.collisions;
  EXPECT_EQ(sumOf(statistics.faces.face_contacts), kinds.left_slope + kinds.right_slope + kinds.level);
  EXPECT_EQ(sumOf(statistics.faces.corner_contacts), kinds.apex);
  EXPECT_EQ(statistics.faces.face_contacts[1], kinds.level);
  EXPECT_GT(kinds.level, 10u);
}

TEST_F(Profile, IsDrawnByItsCorners)
{
  std::vector<visualization_msgs::Marker> outlines;
  const ros::Subscriber markers = sieve_->node.subscribe<visualization_msgs::MarkerArray>(
      "markers", 10,
      [&](const visualization_msgs::MarkerArray::ConstPtr& message)
      {
        for (const visualization_msgs::Marker& marker : message->markers)
          if (marker.ns == "base" && marker.type == visualization_msgs::Marker::LINE_LIST)
            outlines.push_back(marker);
      });
  ASSERT_TRUE(waitFor([&] { return !outlines.empty(); }));
  const BaseDefinition base = scene().base;
  const std::size_t faces = base.profile.size() - 1;
  const auto& points = outlines.back().points;
  ASSERT_EQ(points.size(), 2 * faces * static_cast<std::size_t>(base.teeth));
  for (std::size_t k = 0; k < points.size(); ++k)
  {
    const std::size_t face = k / 2;
    const OutlineCorner& corner = base.profile[face % faces + k % 2];
    EXPECT_DOUBLE_EQ(points[k].x, static_cast<double>(face / faces) * base.toothWidth() + corner.s);
    EXPECT_DOUBLE_EQ(points[k].z, corner.n);
  }
}

TEST_F(Profile, IsRecordedAndSimulatedAgainBitForBit)
{
  sieve_->stepAndSee(0.5);
  sieve_->publish("inclination", 0.1);
  ASSERT_TRUE(waitFor([&] { return sieve_->base.frames.back().base.commanded_inclination == 0.1; }));
  sieve_->stepAndSee(1.0);
  node_->interrupt();
  ASSERT_EQ(node_->wait(), 0) << node_->errors();
  CollectingSink recorded;
  readBag(bag(), recorded);
  EXPECT_TRUE(sameBits(recorded.particles.back(), sieve_->particles.frames.back()));
  EXPECT_EQ(recorded.statistics.back().faces.face_contacts,
            sieve_->statistics.frames.back().faces.face_contacts);
  ChildNode again("sieve_resimulate", {bag()});
  EXPECT_EQ(again.wait(), 0) << again.errors();
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "profile_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
