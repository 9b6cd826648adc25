#include <algorithm>
#include <cstdlib>
#include <set>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "child_node.h"
#include "collecting_sink.h"
#include "file_size_limit.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "sieve_client.h"
#include "small_scenes.h"
#include "statuses.h"

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
  ros::param::set("/interrupted/scene/observe", std::vector<std::string>{"height_profile"});
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
  EXPECT_TRUE(sameButForSpeed(recorded.statistics.back(), sieve.statistics.frames.back()));
  ASSERT_TRUE(sieve.observed.waitForTime(2.4876));
  std::vector<double> times;
  for (const ObservedFrame& frame : recorded.observed)
    times.push_back(frame.time);
  EXPECT_EQ(times, (std::vector<double>{0.0, 1.0, 1.5, 2.0, 2.4876}));  // and at the end of each step
  EXPECT_TRUE(sameBits(recorded.observed.back(), sieve.observed.frames.back()));
  EXPECT_EQ(recorded.observed.back().observed.at(0).name, "height_profile");
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
  EXPECT_TRUE(recorded.observed.empty());
  EXPECT_TRUE(sieve.observed.frames.empty());
}

/// Number of times up to `until`.
template <typename Frame>
std::size_t instantsUpTo(double last, const std::vector<Frame>& frames)
{
  std::set<double> times;
  for (const Frame& frame : frames)
    if (frame.time <= last)
      times.insert(frame.time);
  return times.size();
}

/// Checks that every recorded frame was published, and that none is missing up to the last recorded one.
template <typename Frame, typename Same>
void expectPublished(const std::vector<Frame>& recorded, const std::vector<Frame>& published,
                     const Same& same)
{
  ASSERT_FALSE(recorded.empty());
  const double last = recorded.back().time;
  EXPECT_EQ(instantsUpTo(last, recorded), instantsUpTo(last, published));
  for (const Frame& frame : recorded)
    EXPECT_TRUE(std::any_of(published.begin(), published.end(),
                            [&](const Frame& candidate) { return same(frame, candidate); }))
        << frame.time;
}

void expectPublished(const CollectingSink& recorded, const SieveClient& sieve)
{
  const auto same = [](const auto& a, const auto& b) { return sameBits(a, b); };
  expectPublished(recorded.particles, sieve.particles.frames, same);
  expectPublished(recorded.bins, sieve.bins.frames, same);
  expectPublished(recorded.bases, sieve.base.frames, same);
  const auto same_statistics = [](const StatisticsFrame& a, const StatisticsFrame& b)
  { return sameButForSpeed(a, b); };
  expectPublished(recorded.statistics, sieve.statistics.frames, same_statistics);
}

CollectingSink readAll(const std::vector<std::string>& paths)
{
  CollectingSink read;
  readBags(paths, read);
  return read;
}

/// Steps with at most as many frames as a publisher's queue holds, so that none is lost.
void stepAndSeeAll(SieveClient& sieve, int quarters)
{
  for (int k = 0; k < quarters; ++k)
    sieve.stepAndSee(0.25);
}

TEST_F(Record, holdsWhatItIsAskedToInFilesOfItsOwn)
{
  prepare("/choosy", 1.0, true);
  ros::param::set("/choosy/recording/particles", 0);
  ros::param::set("/choosy/recording/bins", 20.0);
  ros::param::set("/choosy/recording/base", 0.0);
  ros::param::set("/choosy/recording/statistics", 5.0);
  ros::param::set("/choosy/recording/split_duration", 0.5);
  ChildNode node("sieve_node", named("choosy"));
  SieveClient sieve("/choosy");
  ASSERT_TRUE(sieve.connect());
  sieve.publish("inclination", 0.125);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.125; }));
  sieve.stepAndSee(1.25);
  node.interrupt();
  EXPECT_EQ(node.wait(), 0) << node.errors();

  const CollectingSink recorded =
      readAll({scratch_ / "run_1.bag", scratch_ / "run_0.bag", scratch_ / "run_2.bag"});
  EXPECT_EQ(recorded.scenes.size(), 1u);
  EXPECT_TRUE(recorded.particles.empty());
  EXPECT_TRUE(recorded.bases.empty());
  EXPECT_EQ(recorded.bins.size(), 26u);
  EXPECT_EQ(recorded.statistics.size(), 8u);  // the last one is at 1.25 s
  EXPECT_TRUE(sameBits(recorded.bins.back(), sieve.bins.frames.back()));
  EXPECT_EQ(recorded.bins.at(1).time, 0.05);
  EXPECT_FALSE(std::filesystem::exists(scratch_ / "run_3.bag"));
  EXPECT_FALSE(std::filesystem::exists(bag()));
}

TEST_F(Record, losesNoMoreThanASecondWhenKilled)
{
  prepare("/killed", 1.0, true);
  ros::param::set("/killed/recording/particles", 60);
  ChildNode node("sieve_node", named("killed"));
  SieveClient sieve("/killed");
  ASSERT_TRUE(sieve.connect());
  stepAndSeeAll(sieve, 9);
  sieve.publish("inclination", 0.125);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_inclination == 0.125; }));
  stepAndSeeAll(sieve, 12);
  sieve.stepAndSee(0.1);
  node.killAtOnce();
  EXPECT_EQ(node.wait(), -1);

  const std::string active = bag() + ".active";
  EXPECT_FALSE(std::filesystem::exists(bag()));
  EXPECT_THROW(readAll({active}), BagError);
  // The same with a partially written chunk.
  const std::string torn = scratch_ / "torn.bag";
  std::filesystem::copy_file(active, torn);
  constexpr std::size_t HEAD = 4117;  // bytes before the first chunk
  std::ofstream(torn, std::ios::binary | std::ios::app) << contents(active).substr(HEAD, 1000);
  for (const std::string& path : {active, torn})
  {
    ASSERT_EQ(std::system(("rosbag reindex --quiet " + path).c_str()), 0);
    EXPECT_EQ(std::system(("rosbag check " + path).c_str()), 0);
    const CollectingSink recorded = readAll({path});
    EXPECT_EQ(recorded.scenes.size(), 1u);
    EXPECT_GT(recorded.bins.back().time, 5.35 - 1.0 - 1.0 / 60.0);
    EXPECT_EQ(recorded.particles.back().time, recorded.bins.back().time);
    expectPublished(recorded, sieve);
  }
}

TEST_F(Record, endsOneRunAndBeginsTheNextAtAReset)
{
  prepare("/twice", 1.0, true);
  ros::param::set("/twice/recording/particles", 60);
  ChildNode node("sieve_node", named("twice"));
  SieveClient sieve("/twice");
  ASSERT_TRUE(sieve.connect());
  stepAndSeeAll(sieve, 6);
  sieve.publish("frequency", 25.0);
  ASSERT_TRUE(waitFor([&] { return sieve.base.frames.back().base.commanded_frequency == 25.0; }));
  sieve.stepAndSee(0.321);
  ASSERT_TRUE(sieve.reset(5).success);
  // Before any frame of the second run was compared.
  const CollectingSink first = readAll({bag()});
  EXPECT_EQ(first.scenes.at(0).seed, 7u);
  EXPECT_EQ(first.particles.back().time, 1.821);
  EXPECT_EQ(first.bases.back().base.commanded_frequency, 25.0);
  expectPublished(first, sieve);

  sieve.forget();
  stepAndSeeAll(sieve, 3);
  node.interrupt();
  EXPECT_EQ(node.wait(), 0) << node.errors();
  const CollectingSink second = readAll({scratch_ / "run_run2.bag"});
  EXPECT_EQ(second.scenes.at(0).seed, 5u);
  EXPECT_EQ(second.particles.front().time, 0.0);
  EXPECT_EQ(second.particles.back().time, 0.75);
  expectPublished(second, sieve);
}

TEST_F(Record, goesOnWhereTheDiskIsFull)
{
  prepare("/full", 1.0, true);
  std::unique_ptr<ChildNode> node;
  {
    const FileSizeLimit limit(100'000);
    node = std::make_unique<ChildNode>("sieve_node", named("full"));
  }
  SieveClient sieve("/full");
  Statuses statuses(sieve.node);
  ASSERT_TRUE(sieve.connect());
  sieve.stepAndSee(15.0);
  const std::string reason = bag() + ": cannot be written: File too large; the bag ends at ";
  ASSERT_TRUE(waitFor(
      [&]
      {
        const auto& status = statuses["full: recording"];
        return status.level == diagnostic_msgs::DiagnosticStatus::ERROR &&
               status.message.rfind(reason, 0) == 0;
      }));
  const CollectingSink recorded = readAll({bag()});
  EXPECT_GT(recorded.bins.back().time, 1.0);
  EXPECT_LT(recorded.bins.back().time, 15.0);
  EXPECT_EQ(std::system(("rosbag check " + bag()).c_str()), 0);
  EXPECT_EQ(recorded.particles.size(), 1 + std::size_t(10.0 * recorded.bins.back().time + 1e-9));

  sieve.stepAndSee(1.0);
  node->interrupt();
  EXPECT_EQ(node->wait(), 1);
  const std::string& said = node->errors();
  const std::size_t told = said.find("the recording was aborted: " + reason);
  EXPECT_NE(told, std::string::npos) << said;
  EXPECT_EQ(said.find("the recording was aborted", told + 1), std::string::npos) << said;
  EXPECT_NE(said.find("sieve_node: the recording of the run is incomplete"), std::string::npos) << said;
  EXPECT_TRUE(sameBits(readAll({bag()}).bins, recorded.bins));
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
  ros::param::set("/odd/rates/base", 60.0);
  ros::param::set("/odd/frame_prefix", "/odd");
  ChildNode again("sieve_node", named("odd"));
  EXPECT_EQ(again.wait(), 2);
  EXPECT_EQ(again.errors(),
            "sieve_node: parameter /odd/frame_prefix: /odd: must be letters, digits, _ and / between them, "
            "beginning with a letter, such as s1\n");
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

TEST_F(Record, doesNotReplaceTheSceneFile)
{
  prepare("/over", 1.0, true);
  const std::string file = scratch_ / "scene.yaml";
  const std::string scene = "species: [{name: A, count: 1, radius: 0.002, mass: 0.001}]\n";
  std::ofstream(file) << scene;
  for (const char* key : {"/over/scene_file", "/over/record"})
    ros::param::set(key, file);
  ChildNode node("sieve_node", named("over"));
  EXPECT_EQ(node.wait(), 2);
  EXPECT_EQ(node.errors(),
            "sieve_node: ~record " + file + ": is the file of ~scene_file; must be another one\n");
  EXPECT_EQ(contents(file), scene);
}

TEST_F(Record, helpsWithoutBeingANode)
{
  for (const char* program : {"sieve_display", "sieve_node"})
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
