#include <fstream>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <std_msgs/Float64.h>
#include <topic_tools/shape_shifter.h>

#include "caught_log.h"
#include "file_size_limit.h"
#include "ratchet_sieve/recording/run.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/recording/version.h"
#include "read_bags.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Hands a short run to the sink.
void showRun(FrameSink& sink)
{
  Run run(Simulation(smallMixture()), 1.0);
  run.add(sink, {60.0, 30.0, 120.0, 10.0});
  run.takeDue();
  while (!run.finished())
    run.advanceTo(run.endTime());
  run.takeAll();
}

std::string writingError(const std::string& path)
{
  return errorOf([&] { BagWriter bag(path); });
}

/// Takes a run twice: into a bag, and into memory for comparison.
class Both : public CollectingSink
{
public:
  explicit Both(FrameSink& bag) : bag_(bag) {}
  void take(const AnyFrame& frame) override
  {
    bag_.take(frame);
    CollectingSink::take(frame);
  }

private:
  FrameSink& bag_;
};

TEST(Bag, holdsStampsAsBagTimeAndSetpoints)
{
  const ScratchDirectory scratch;
  BagWriter bag(scratch / "run.bag", "/other");
  showRun(bag);
  const CommandFrame command{0.75, CommandKind::INCLINATION, {0.125}, 0, 0};
  bag.take(command);
  bag.close();

  rosbag::Bag file(scratch / "run.bag");
  rosbag::View all(file);
  EXPECT_EQ(all.getBeginTime(), ros::TIME_MIN);
  EXPECT_EQ(all.getEndTime(), ros::Time(1.0));
  rosbag::View setpoints(file, rosbag::TopicQuery("/other/inclination_setpoint"));
  ASSERT_EQ(setpoints.size(), 1u);
  EXPECT_EQ(setpoints.begin()->getTime(), ros::Time(0.75));
  EXPECT_EQ(setpoints.begin()->instantiate<std_msgs::Float64>()->data, 0.125);
  std::uint32_t next = 0;
  for (const rosbag::MessageInstance& message : rosbag::View(file, rosbag::TopicQuery("/other/base")))
    EXPECT_EQ(message.instantiate<BaseState>()->header.seq, next++);
  EXPECT_GT(next, 1u);
  const CollectingSink read = readAll({scratch / "run.bag"});
  ASSERT_EQ(read.commands.size(), 1u);
  EXPECT_TRUE(sameBits(read.commands[0], command));
}

TEST(Bag, isReadInTheOrderOfTheFramesOwnTimes)
{
  const ScratchDirectory scratch;
  rosbag::Bag file(scratch / "late.bag", rosbag::bagmode::Write);
  BaseFrame base;
  BinFrame bins;
  // As `rosbag record` may write it: rounded bag times, one topic after the other.
  file.write("/sieve/scene", ros::Time(5.0), toMessage(SceneFrame()));
  for (const double time : {1.0, 2.0, 3.0})
  {
    base.time = time;
    file.write("/sieve/base", ros::Time(5.0), toMessage(base));
  }
  for (const double time : {0.5, 1.0, 2.5})
  {
    bins.time = time;
    file.write("/sieve/bins", ros::Time(5.5), toMessage(bins));
  }
  file.close();

  struct Order : CollectingSink
  {
    void take(const AnyFrame& frame) override
    {
      text += describe(frame.kind()).name;
      if (frame.kind() != FrameKind::SCENE)
        text += std::to_string(frame.time()).substr(0, 3);
      text += " ";
    }
    std::string text;
  } order;
  readBags({scratch / "late.bag"}, order);
  EXPECT_EQ(order.text, "scene bins0.5 base1.0 bins1.0 base2.0 bins2.5 base3.0 ");
}

TEST(Bag, refusesWhatIsNoBagOfARun)
{
  const ScratchDirectory scratch;
  const std::string missing = scratch / "missing.bag";
  EXPECT_EQ(readingError({missing}), missing + ": no such file");

  const std::string text = scratch / "text.bag";
  std::ofstream(text) << "no bag\nat all\n";
  EXPECT_TRUE(begins(readingError({text}), text + ": cannot be read as a bag: ")) << readingError({text});
  std::ofstream(text, std::ios::trunc).close();
  EXPECT_TRUE(begins(readingError({text}), text + ": cannot be read as a bag: ")) << readingError({text});

  const std::string foreign = scratch / "foreign.bag";
  {
    rosbag::Bag file(foreign, rosbag::bagmode::Write);
    file.write("/number", ros::Time(1.0), std_msgs::Float64());
  }
  EXPECT_EQ(readingError({foreign}),
            foreign + ": holds no run: no topic of type ratchet_sieve/SceneDescription");

  const std::string two = scratch / "two.bag";
  {
    rosbag::Bag file(two, rosbag::bagmode::Write);
    file.write("/left/scene", ros::Time(1.0), toMessage(SceneFrame()));
    file.write("/right/scene", ros::Time(1.0), toMessage(SceneFrame()));
  }
  EXPECT_EQ(readingError({two}), two + ": holds several runs: /left/scene and /right/scene");
}

TEST(Bag, refusesWhatWasNotClosedOrIsCutOff)
{
  const ScratchDirectory scratch;
  const std::string whole = scratch / "whole.bag";
  {
    BagWriter bag(whole);
    showRun(bag);
  }
  const std::string cut = scratch / "cut.bag";
  const std::string bytes = contents(whole);
  for (const double part : {0.999, 0.6, 0.01})
  {
    std::ofstream(cut, std::ios::binary) << bytes.substr(0, static_cast<std::size_t>(part * bytes.size()));
    const std::string refusal = readingError({cut});
    EXPECT_TRUE(begins(refusal, cut + ": cannot be read as a bag: ")) << part << ": " << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << refusal;
  }
  BagWriter bag(scratch / "open.bag");
  showRun(bag);
  EXPECT_EQ(readingError({scratch / "open.bag.active"}),
            scratch / "open.bag.active: was not closed, or is damaged: try `rosbag reindex`");
}

/// librosbag reads outside of its buffers there, and would end the program by a signal.
TEST(Bag, whoseIndexIsDamagedEndsAProgramInOneLine)
{
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer says it in its own words";
#endif
  const ScratchDirectory scratch;
  BagWriter bag(scratch / "run.bag", "/sieve");
  showRun(bag);
  bag.close();
  std::string bytes = contents(scratch / "run.bag");
  const std::string index = "op=\x04";
  const std::size_t to_offset = index.size() + 24;  // version, length of the entries, time of the first one
  for (std::size_t k = bytes.find(index); k != std::string::npos; k = bytes.find(index, k + 1))
    bytes.replace(k + to_offset, 4, "\xF0\xFF\xFF\x7F");
  std::ofstream(scratch / "run.bag", std::ios::binary) << bytes;
  EXPECT_EXIT(readAll({scratch / "run.bag"}), testing::ExitedWithCode(1),
              "run.bag: is damaged: try `rosbag reindex`");
}

TEST(Bag, refusesAFrameAtNoTime)
{
  const ScratchDirectory scratch;
  for (const double time : {-1.0, 1e10, std::numeric_limits<double>::quiet_NaN()})
  {
    SceneDescription scene;
    scene.time = time;
    rosbag::Bag(scratch / "b", rosbag::bagmode::Write).write("/sieve/scene", ros::Time(1.0), scene);
    EXPECT_EQ(readingError({scratch / "b"}), scratch / "b: /sieve/scene has a message with an invalid time");
  }
}

/// As `rosbag record` leaves them after a reset to time 0.
TEST(Bag, refusesRunsThatLieUponOneAnother)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "reset.bag";
  const Simulation simulation(smallMixture());
  {
    rosbag::Bag bag(path, rosbag::bagmode::Write);
    bag.write("/sieve/scene", ros::Time(3.0), toMessage(makeSceneFrame(simulation)));
    bag.write("/sieve/bins", ros::Time(3.5), toMessage(makeBinFrame(simulation)));
    bag.write("/sieve/scene", ros::TIME_MIN, toMessage(makeSceneFrame(simulation)));
    bag.write("/sieve/bins", ros::Time(0.5), toMessage(makeBinFrame(simulation)));
  }
  EXPECT_EQ(readingError({path}),
            path +
                ": holds two runs from 0.000000 s on, as `rosbag record` keeps them across a ~reset: record "
                "with the node's ~record, or reset with keep_time");
}

/// A node is killed and restarted twice before the user handles its files.
TEST(Bag, setsAsideWhatWasNotClosed)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "run.bag";
  const CaughtLog log;
  for (const char* left : {"first", "second"})
  {
    std::ofstream(path + ".active") << left;
    BagWriter bag(path);
    showRun(bag);
  }
  EXPECT_EQ(contents(path + ".unfinished.active"), "first");
  EXPECT_EQ(contents(path + ".unfinished2.active"), "second");
  EXPECT_EQ(readingError({path}), "done");
  const std::string first = path + ".unfinished.active";
  EXPECT_EQ(log.count(path + ".active was left by a program that was killed: renamed to " + first +
                      "; `rosbag reindex " + first + "` adds its index"),
            1u);
  EXPECT_EQ(log.count("run.bag.unfinished2.active"), 1u);
}

/// `rosbag reindex` keeps the name, FILE.active.
TEST(Bag, advisesNoIndexWhereThereIsOne)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "run.bag";
  {
    BagWriter bag(path);
    showRun(bag);
  }
  std::filesystem::rename(path, path + ".active");
  const CaughtLog log;
  BagWriter bag(path);
  const std::string aside = path + ".unfinished.active";
  EXPECT_EQ(log.count("renamed to " + aside + "; it has an index and can be read"), 1u);
  EXPECT_EQ(log.count("reindex"), 0u);
  EXPECT_EQ(readingError({aside}), "done");
}

/// For a file name of the maximum length, no longer name is possible.
TEST(Bag, leavesAloneWhatCannotBeSetAside)
{
  constexpr std::size_t LONGEST_NAME = 255;
  const ScratchDirectory scratch;
  const std::string active = ".active";
  const std::string path = scratch / std::string(LONGEST_NAME - active.size(), 'r');
  std::ofstream(path + active) << "first";
  EXPECT_EQ(writingError(path), path + ": cannot be written: there is " + path + active +
                                    ", which was not closed and cannot be renamed: File name too long");
  EXPECT_EQ(contents(path + active), "first");
}

TEST(Bag, givesARunBackBitForBitAndIsLeftAloneBefore)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "run.bag";
  BagWriter bag(path);
  Both written(bag);
  showRun(written);
  EXPECT_EQ(writingError(path), path + ": cannot be written: another program is recording into it");
  EXPECT_FALSE(std::filesystem::exists(path + ".unfinished.active"));
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(std::filesystem::exists(path + ".active"));
  bag.close();
  EXPECT_FALSE(std::filesystem::exists(path + ".active"));
  const CollectingSink read = readAll({path});
  EXPECT_EQ(read.particles.size(), 61u);
  EXPECT_TRUE(sameBits(read.scenes, written.scenes));
  EXPECT_TRUE(sameBits(read.particles, written.particles));
  EXPECT_TRUE(sameBits(read.bins, written.bins));
  EXPECT_TRUE(sameBits(read.bases, written.bases));
  EXPECT_TRUE(sameBits(read.statistics, written.statistics));
}

/// A run that is refused, or whose first message finds no room.
TEST(Bag, replacesNothingBeforeItHasBegun)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "run.bag";
  std::ofstream(path) << "an earlier one";
  BagWriter(path, "/sieve");
  {
    const FileSizeLimit full(5'500);
    BagWriter bag(path);
    EXPECT_THROW(bag.take(makeSceneFrame(Simulation(smallMixture()))), BagError);
    EXPECT_EQ(errorOf([&] { bag.close(); }), path + ": cannot be written: File too large");
  }
  EXPECT_EQ(contents(path), "an earlier one");
  EXPECT_FALSE(std::filesystem::exists(path + ".active"));
}

TEST(Bag, replacesNoBagThatIsRecorded)
{
  const ScratchDirectory scratch;
  const std::string active = scratch / "run.bag.active";
  const BagWriter bag(scratch / "run.bag");
  EXPECT_EQ(writingError(active), active + ": cannot be written: another program is writing it");
}

TEST(Bag, takesThePlaceOfNothingButAFile)
{
  const ScratchDirectory scratch;
  std::filesystem::create_directory(scratch / "run.bag");
  std::filesystem::create_symlink("/dev/null", scratch / "null.bag");
  for (const std::string& path : {scratch / "run.bag", scratch / "null.bag", scratch / "nowhere/run.bag"})
  {
    EXPECT_NE(writingError(path).find(": cannot be written: "), std::string::npos) << writingError(path);
    EXPECT_FALSE(std::filesystem::exists(path + ".active"));
  }
  EXPECT_TRUE(std::filesystem::is_symlink(scratch / "null.bag"));
}

/// A message whose definition nobody knows.
template <typename Message>
topic_tools::ShapeShifter unknown(const Message& message)
{
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  const auto size = static_cast<std::uint32_t>(bytes.size());
  ros::serialization::OStream written(bytes.data(), size);
  ros::serialization::serialize(written, message);
  topic_tools::ShapeShifter shifter;
  shifter.morph("0123456789abcdef0123456789abcdef", ros::message_traits::datatype<Message>(), "", "");
  ros::serialization::IStream read(bytes.data(), size);
  shifter.read(read);
  return shifter;
}

TEST(Bag, ofALaterVersionIsRefusedByTypeAndVersions)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "later.bag";
  const Simulation simulation(smallMixture());
  SceneFrame scene = makeSceneFrame(simulation);
  scene.version = "1234.5.6";
  rosbag::Bag file(path, rosbag::bagmode::Write);
  file.write("/sieve/scene", ros::TIME_MIN, toMessage(scene));
  file.write("/sieve/bins", ros::TIME_MIN, unknown(toMessage(makeBinFrame(simulation))));
  file.close();
  const std::string program = std::string("that ratchet_sieve ") + version() + " does not know";
  EXPECT_EQ(readingError({path}), path + ": /sieve/bins has a ratchet_sieve/BinCounts " + program +
                                      ", recorded by ratchet_sieve 1234.5.6");
  file.open(path, rosbag::bagmode::Write);
  file.write("/sieve/scene", ros::TIME_MIN, unknown(toMessage(scene)));
  file.close();
  EXPECT_EQ(readingError({path}), path + ": /sieve/scene has a ratchet_sieve/SceneDescription " + program);
}
}  // namespace
}  // namespace ratchet_sieve
