#include <gtest/gtest.h>

#include "child_node.h"
#include "collecting_sink.h"
#include "own_master.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "ratchet_sieve/ros/scene_parameters.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// roscpp's message on standard error.
constexpr const char* WAITING = "Failed to contact master at [localhost:";

TEST(Masterless, aNodeSaysThatItWaitsForTheMasterAndCanBeEnded)
{
  OwnMaster master;
  ChildNode node("sieve_node", {"__name:=early"});
  ASSERT_TRUE(node.waitForError(WAITING)) << node.errors();
  EXPECT_TRUE(node.running());
  node.interrupt();
  EXPECT_EQ(node.wait(), -1);  // ended by the signal
  EXPECT_EQ(node.errors().find(WAITING), node.errors().rfind(WAITING)) << node.errors();
}

TEST(Masterless, aNodeGoesOnOnceThereIsAMaster)
{
  OwnMaster master;
  ChildNode node("sieve_node", {"__name:=early"});
  ASSERT_TRUE(node.waitForError(WAITING)) << node.errors();
  master.start();
  // It proceeds to the missing scene.
  EXPECT_EQ(node.wait(), 2);
  EXPECT_NE(node.errors().find("sieve_node: parameter /early/scene_file: not set"), std::string::npos)
      << node.errors();
}

/// The only test in which this process is a node, because it can use only one master.
TEST(Masterless, runGoesOnWhereTheMasterGoesAway)
{
  OwnMaster master;
  master.start();
  int argc = 0;
  ros::init(argc, nullptr, "masterless_test");
  const ros::NodeHandle handle;  // waits for the master
  const ScratchDirectory scratch;
  const std::string bag = scratch / "run.bag";
  const auto set = [](const std::string& name, const auto& value)
  { ros::param::set("/orphan/" + name, value); };
  XmlRpc::XmlRpcValue species;
  species[0]["name"] = "A";
  species[0]["count"] = 20;
  species[0]["radius"] = 0.001;
  species[0]["mass"] = 0.01;
  set("scene/base/teeth", 4);
  set("scene/base/inclination", 0.02);
  set("scene/species", species);
  set("scene/duration", 1000.0);
  set("record", bag);
  set("start_paused", true);

  ChildNode node("sieve_node", {"__name:=orphan"});
  SieveClient sieve("/orphan");
  ASSERT_TRUE(sieve.connect());
  sieve.stepAndSee(0.5);
  ASSERT_TRUE(sieve.call("unpause_physics"));
  master.kill();
  ASSERT_FALSE(ros::master::check());

  // Frames and setpoints are exchanged directly between nodes; only new connections need the master.
  const double orphaned = sieve.base.frames.back().time;
  ASSERT_TRUE(waitFor([&] { return sieve.particles.frames.back().time > orphaned + 1.0; }));
  sieve.publish("inclination", 0.125);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.125; }));
  const double commanded = sieve.base.frames.back().time;
  ASSERT_TRUE(waitFor([&] { return sieve.statistics.frames.back().time > commanded + 0.2; }));
  EXPECT_TRUE(node.running());

  // A new master does not know the node, which continues and ends normally.
  master.start();
  ASSERT_TRUE(waitFor([] { return ros::master::check(); }));
  const double under_another = sieve.base.frames.back().time;
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().time > under_another + 0.2; }));
  node.interrupt();
  EXPECT_EQ(node.wait(), 0) << node.errors();

  CollectingSink recorded;
  readBag(bag, recorded);
  EXPECT_EQ(recorded.particles.front().time, 0.0);
  EXPECT_GT(recorded.particles.back().time, commanded);
  EXPECT_EQ(recorded.bases.back().base.commanded_inclination, 0.125);
  // The received frames are equal to those in the bag, to the end.
  for (const BinFrame& seen : sieve.bins.frames)
  {
    const auto same = [&](const BinFrame& frame) { return frame.time == seen.time; };
    const auto found = std::find_if(recorded.bins.begin(), recorded.bins.end(), same);
    ASSERT_NE(found, recorded.bins.end()) << "at " << seen.time;
    ASSERT_TRUE(sameBits(*found, seen));
  }
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
