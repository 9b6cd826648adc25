#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>

#include "file_size_limit.h"
#include "node_reports.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "read_bags.h"
#include "started_node.h"

namespace ratchet_sieve
{
namespace
{
/// Nodes that record into bag().
class Record : public testing::Test
{
protected:
  std::string bag() const { return scratch_ / "run.bag"; }

  ScratchDirectory scratch_;
};

TEST_F(Record, holdsTheFirstAndTheLastMessageWhenInterrupted)
{
  XmlRpc::XmlRpcValue observe;
  observe[0] = "height_profile";
  StartedNode started("/interrupted", {{"record", bag()}, {"scene/observe", observe}});
  SieveClient& sieve = started.sieve;
  sieve.stepAndSee(1.5);
  sieve.command("inclination", 0.125);
  sieve.stepAndSee(0.9876);
  EXPECT_EQ(started.end(), 0) << started.node->errors();

  EXPECT_FALSE(std::filesystem::exists(bag() + ".active"));
  const CollectingSink recorded = readAll({bag()});
  EXPECT_EQ(recorded.particles.front().time, 0.0);
  EXPECT_EQ(recorded.particles.back().time, 2.4876);
  EXPECT_TRUE(sameBits(recorded.particles.back(), sieve.particles.frames.back()));
  EXPECT_TRUE(sameBits(recorded.bins.back(), sieve.bins.frames.back()));
  EXPECT_TRUE(sameButForSpeed(recorded.statistics.back(), sieve.statistics.frames.back()));
  ASSERT_TRUE(sieve.observed.waitForTime(2.4876));
  std::vector<double> times;
  for (const ObservedFrame& frame : recorded.observed)
    times.push_back(frame.time);
  EXPECT_EQ(times, (std::vector<double>{0.0, 1.0, 1.5, 2.0, 2.4876}));  // and at the end of each step
  EXPECT_TRUE(sameBits(recorded.observed.back(), sieve.observed.frames.back()));
  EXPECT_EQ(std::system(("rosbag check " + bag()).c_str()), 0);
}

TEST_F(Record, endsWithTheSceneAndClosesTheBag)
{
  StartedNode started("/finishing", {{"record", bag()}, {"real_time_factor", 0.0}, {"exit_at_end", true}});
  ASSERT_TRUE(started.sieve.call("unpause_physics"));
  EXPECT_EQ(started.node->wait(), 0) << started.node->errors();
  ASSERT_TRUE(started.sieve.bins.waitForTime(20.0));
  const CollectingSink recorded = readAll({bag()});
  EXPECT_EQ(recorded.bins.size(), 20u * 60u + 1u);
  EXPECT_TRUE(sameBits(recorded.bins.back(), started.sieve.bins.frames.back()));
  EXPECT_TRUE(recorded.observed.empty());
}

TEST_F(Record, holdsWhatItIsAskedToInFilesOfItsOwn)
{
  StartedNode started("/choosy", {{"record", bag()},
                                  {"recording/particles", 0},
                                  {"recording/bins", 20.0},
                                  {"recording/base", 0.0},
                                  {"recording/statistics", 5.0},
                                  {"recording/split_duration", 0.5}});
  started.sieve.stepAndSee(1.25);
  EXPECT_EQ(started.end(), 0) << started.node->errors();
  const CollectingSink recorded =
      readAll({scratch_ / "run_1.bag", scratch_ / "run_0.bag", scratch_ / "run_2.bag"});
  EXPECT_TRUE(recorded.particles.empty() && recorded.bases.empty());
  EXPECT_EQ(recorded.bins.size(), 26u);
  EXPECT_EQ(recorded.statistics.size(), 8u);  // the last one is at 1.25 s
  EXPECT_FALSE(std::filesystem::exists(bag()));
}

TEST_F(Record, goesOnWhereTheDiskIsFull)
{
  std::optional<FileSizeLimit> limit(100'000);
  StartedNode started("/full", {{"record", bag()}});
  limit.reset();
  Statuses statuses(started.sieve.node);
  started.sieve.stepAndSee(15.0);
  const std::string reason = bag() + ": cannot be written: File too large; the bag ends at ";
  ASSERT_TRUE(statuses.waitFor("full: recording", diagnostic_msgs::DiagnosticStatus::ERROR, reason));
  const CollectingSink recorded = readAll({bag()});
  EXPECT_GT(recorded.bins.back().time, 1.0);
  EXPECT_LT(recorded.bins.back().time, 15.0);
  EXPECT_EQ(std::system(("rosbag check " + bag()).c_str()), 0);
  EXPECT_EQ(recorded.particles.size(), 1 + std::size_t(10.0 * recorded.bins.back().time + 1e-9));

  started.sieve.stepAndSee(1.0);
  EXPECT_EQ(started.end(), 1);
  const std::string& said = started.node->errors();
  const std::size_t told = said.find("the recording was aborted: " + reason);
  EXPECT_NE(told, std::string::npos) << said;
  EXPECT_EQ(said.find("the recording was aborted", told + 1), std::string::npos) << said;
  EXPECT_NE(said.find("sieve_node: the recording of the run is incomplete"), std::string::npos) << said;
  EXPECT_TRUE(sameBits(readAll({bag()}).bins, recorded.bins));
}

TEST_F(Record, refusesInOneLineWhatCannotBegin)
{
  const std::string file = scratch_ / "scene.yaml", nowhere = scratch_ / "nowhere/run.bag";
  const std::string scene = "species: [{name: A, count: 1, radius: 0.002, mass: 0.001}]\n";
  std::ofstream(file) << scene;
  const std::string feed = scratch_ / "feed.csv";
  std::ofstream(feed) << "time,species,radius,mass\n0.1,A,0.002,0.001\n";
  const std::vector<std::pair<Parameters, std::string>> bad = {
      {{{"record", bag()}, {"scene/base/asymmetry", 3.0}},
       "parameter /bad/scene: base.asymmetry = 3: must be "},
      {{{"scene_file", file}, {"scene/duration", -1.0}}, file + ": duration = -1: must be "},
      {{{"record", bag()}, {"rates/base", -1.0}},
       "parameter /bad/rates/base: -1: must be a number from 0 to 100000\n"},
      {{{"frame_prefix", "/odd"}},
       "parameter /bad/frame_prefix: /odd: must be letters, digits, _ and / between them, beginning with a "
       "letter, such as s1\n"},
      {{{"record", nowhere}, {"publish_clock", false}}, nowhere + ": cannot be written: "},
      {{{"scene_file", file}, {"record", file}},
       "~record " + file + ": is the file of ~scene_file; must be another one\n"},
      {{{"scene_file", file}, {"scene/feed/file", feed}, {"record", feed}},
       "~record " + feed + ": is the file of feed.file; must be another one\n"}};
  for (const auto& [parameters, error] : bad)
  {
    ros::param::del("/bad");
    setParameters("/bad", parameters);
    ChildNode node("sieve_node", {"__name:=bad"});
    EXPECT_EQ(node.wait(), 2);
    EXPECT_EQ(node.errors().rfind("sieve_node: " + error, 0), 0u) << node.errors();
    EXPECT_EQ(node.errors().find('\n'), node.errors().size() - 1) << node.errors();
  }
  EXPECT_EQ(contents(file), scene);
  EXPECT_FALSE(std::filesystem::exists(bag()) || std::filesystem::exists(bag() + ".active"));
}
}  // namespace
}  // namespace ratchet_sieve
