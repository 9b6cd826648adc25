#include <gtest/gtest.h>

#include "child_node.h"
#include "own_master.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "read_bags.h"
#include "sieve_client.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// roscpp's message on standard error.
constexpr const char* WAITING = "Failed to contact master at [localhost:";

TEST(Masterless, aNodeSaysThatItWaitsForTheMasterAndGoesOnOnceThereIsOne)
{
  OwnMaster master;
  ChildNode ended("sieve_node", {"__name:=ended"});
  ASSERT_TRUE(ended.waitForError(WAITING)) << ended.errors();
  ended.interrupt();
  EXPECT_EQ(ended.wait(), -1);  // by the signal
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
  std::ofstream(scratch / "scene.yaml") << "base: {teeth: 4, inclination: 0.02}\nduration: 1000\n"
                                           "species: [{name: A, count: 20, radius: 0.001, mass: 0.01}]\n";
  ros::param::set("/orphan/scene_file", scratch / "scene.yaml");
  ros::param::set("/orphan/record", bag);
  ros::param::set("/orphan/start_paused", true);

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
  sieve.command("inclination", 0.125);
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

  const CollectingSink recorded = readAll({bag});
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
