#include "bag_file.h"

#include <cstdlib>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>
#include <malloc.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/String.h>

#include "errors.h"
#include "file_size_limit.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Incompressible numbers.
std_msgs::Float64MultiArray noise(std::size_t count, unsigned seed)
{
  std::mt19937_64 random(seed);
  std_msgs::Float64MultiArray message;
  for (std::size_t k = 0; k < count; ++k)
    message.data.push_back(std::generate_canonical<double, 53>(random));
  return message;
}

/// What rosbag reads of the noise on a topic.
std::vector<std_msgs::Float64MultiArray> readNoise(const std::string& path)
{
  rosbag::Bag bag(path);
  rosbag::View all(bag);
  std::vector<std_msgs::Float64MultiArray> messages;
  for (const rosbag::MessageInstance& instance : all)
    if (const auto message = instance.instantiate<std_msgs::Float64MultiArray>())
      messages.push_back(*message);
  return messages;
}

TEST(BagFile, isReadByRosbag)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "a.bag";
  BagFile file(path);
  std_msgs::String text;
  text.data = "kept";
  file.write("/text", ros::Time(1, 5), text, true);
  file.write("/noise", ros::Time(1, 6), noise(3, 1));
  file.write("/noise", ros::Time(2, 999999999), noise(4, 2));
  EXPECT_FALSE(file.close());
  EXPECT_FALSE(file.close());

  rosbag::Bag bag(path);
  rosbag::View all(bag);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all.getBeginTime(), ros::Time(1, 5));
  EXPECT_EQ(all.getEndTime(), ros::Time(2, 999999999));
  EXPECT_EQ(all.begin()->getTopic(), "/text");
  EXPECT_EQ(all.begin()->instantiate<std_msgs::String>()->data, "kept");
  EXPECT_TRUE(all.begin()->isLatching());
  rosbag::View numbers(bag, rosbag::TopicQuery("/noise"));
  EXPECT_FALSE(numbers.begin()->isLatching());
  EXPECT_EQ(readNoise(path).at(1).data, noise(4, 2).data);
}

/// What is in the file of messages that were written and not closed.
std::vector<std_msgs::Float64MultiArray> recovered(const std::string& path)
{
  const std::string copy = path + ".copy.bag";
  std::filesystem::copy_file(path, copy, std::filesystem::copy_options::overwrite_existing);
  EXPECT_EQ(std::system(("rosbag reindex --quiet " + copy).c_str()), 0);
  return readNoise(copy);
}

TEST(BagFile, isOnTheDiskOnceItIsASecondOld)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "a.bag";
  BagFile file(path);
  for (const std::uint32_t k : {0u, 4u, 9u})
    file.write("/noise", ros::Time(7, k * 100'000'000), noise(5, k));
  const std::uintmax_t head = std::filesystem::file_size(path);
  EXPECT_LT(head, 5000u);
  EXPECT_GT(file.size(), head + 3 * 5 * sizeof(double));
  for (const unsigned k : {0u, 1u})
    file.write("/noise", ros::Time(8, 0), noise(5, 10 + k));
  file.write("/noise", ros::Time(8, 1), noise(5, 12));
  const auto messages = recovered(path);
  ASSERT_EQ(messages.size(), 5u);
  EXPECT_EQ(messages.at(4).data, noise(5, 11).data);
  EXPECT_FALSE(file.close());
  EXPECT_EQ(readNoise(path).size(), 6u);
}

/// rosbag keeps the messages of a chunk in memory until it ends a chunk by itself.
TEST(BagFile, keepsNoMessagesInMemory)
{
  const ScratchDirectory scratch;
  BagFile file(scratch / "a.bag");
  const auto used = [] { return mallinfo2().uordblks + mallinfo2().hblkhd; };
  std::size_t before = 0;
  for (std::uint32_t k = 0; k < 300; ++k)
  {
    if (k == 100)
      before = used();
    file.write("/noise", ros::Time(1 + k / 2, k % 2 * 500'000'000), noise(20'000, k));
  }
  EXPECT_LT(used(), before + 10 * 20'000 * sizeof(double));
}

/// After a full disk all messages that were taken are readable, for any limit: within a chunk, within its
/// index, or without space for the file's index.
TEST(BagFile, keepsWhatFitsWhereTheDiskIsFull)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "a.bag";
  constexpr std::size_t COUNT = 50;  // numbers per message: 0.4 kB
  for (std::size_t limit = 6'000; limit < 30'000; limit += 389)
  {
    const FileSizeLimit full(limit);
    BagFile file(path);
    std::uint32_t written = 0;
    EXPECT_THROW(
        while (true) {
          file.write("/noise", ros::Time(1 + written / 4, written % 4 * 250'000'000), noise(COUNT, written));
          ++written;
        },
        BagError);
    EXPECT_THROW(file.write("/noise", ros::Time(1000, 0), noise(COUNT, 0)), BagError);
    const auto loss = file.close();
    ASSERT_TRUE(loss) << limit;
    EXPECT_EQ(loss->reason, "File too large");

    const auto read = readNoise(path);
    ASSERT_EQ(read.size(), written) << limit;
    // Two times the header, two times the connection, and a few chunks.
    EXPECT_GE(read.size() * 900 + 2 * 4'600 + 2 * 1'700 + 3'000, limit);
    for (std::uint32_t k = 0; k < read.size(); ++k)
      ASSERT_EQ(read[k].data, noise(COUNT, k).data) << limit;
    if (!read.empty())
    {
      EXPECT_EQ(loss->end, ros::Time(1 + (written - 1) / 4, (written - 1) % 4 * 250'000'000));
    }
  }
}

TEST(BagFile, isRefusedWhereNothingFits)
{
  const ScratchDirectory scratch;
  std::filesystem::create_symlink("/dev/full", scratch / "a.bag");
  const std::string error = errorOf([&] { BagFile file(scratch / "a.bag"); });
  EXPECT_TRUE(begins(error, "Error writing to file: ")) << error;
  EXPECT_TRUE(scratch.empty());
}

TEST(BagFile, staysLockedUntilItHasItsName)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "run.bag.active";
  {
    BagFile file(path);
    EXPECT_FALSE(file.close());
    EXPECT_TRUE(LockedFile::isLocked(path));
  }
  EXPECT_FALSE(LockedFile::isLocked(path));
}
}  // namespace
}  // namespace ratchet_sieve
