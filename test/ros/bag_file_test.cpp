#include "ratchet_sieve/bag/bag_file.h"

#include <filesystem>
#include <random>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/String.h>

#include "file_size_limit.h"
#include "ratchet_sieve/bag/bag_structure.h"
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

  EXPECT_NO_THROW(requireSoundBag(path));
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

TEST(BagFile, holdsWhatIsLargerThanABlock)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "a.bag";
  BagFile file(path);
  for (unsigned k = 1; k <= 3; ++k)
    file.write("/noise", ros::Time(k, 0), noise(k * 400'000, k));
  EXPECT_FALSE(file.close());
  EXPECT_NO_THROW(requireSoundBag(path));
  const auto read = readNoise(path);
  ASSERT_EQ(read.size(), 3u);
  for (unsigned k = 1; k <= 3; ++k)
    EXPECT_EQ(read[k - 1].data, noise(k * 400'000, k).data);
}

TEST(BagFile, isEmptyBeforeItsFirstMessage)
{
  const ScratchDirectory scratch;
  BagFile(scratch / "a.bag").close();
  EXPECT_NO_THROW(requireSoundBag(scratch / "a.bag"));
  EXPECT_TRUE(readNoise(scratch / "a.bag").empty());
}

TEST(BagFile, writesAChunkOutOnceItIsASecondLongOrLarge)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "a.bag";
  BagFile file(path);
  const auto size = [&]
  {
    file.size();  // waits until a finished chunk is in the file
    return std::filesystem::file_size(path);
  };
  const std::uintmax_t head = size();
  for (const std::uint32_t k : {0u, 4u, 9u})
    file.write("/noise", ros::Time(7, k * 100'000'000), noise(5, 1));
  EXPECT_EQ(size(), head);
  file.write("/noise", ros::Time(8, 0), noise(5, 1));
  const std::uintmax_t one_chunk = size();
  EXPECT_GT(one_chunk, head);
  file.write("/noise", ros::Time(8, 1), noise(BagFile::CHUNK_SIZE / 8, 1));
  EXPECT_GT(size(), one_chunk + BagFile::CHUNK_SIZE / 2);
  EXPECT_EQ(file.size(), size());
}

/// After a full disk, all data but the last chunk or two are readable, for any limit: within a chunk, within
/// its index, or without space for the file's index.
TEST(BagFile, keepsWhatFitsWhereTheDiskIsFull)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "a.bag";
  constexpr std::size_t COUNT = 50;  // numbers per message: 0.4 kB
  for (std::size_t limit = 4'200; limit < 30'000; limit += 389)
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

    EXPECT_NO_THROW(requireSoundBag(path)) << limit;
    const auto read = readNoise(path);
    // Of the limit, the file's header takes 4.1 kB, the connection twice 1.7 kB, and a chunk 2.2 kB.
    EXPECT_GE(read.size() * 560 + 4'100 + 2 * 1'700 + 2'200, limit);
    EXPECT_LE(read.size(), written);
    for (std::uint32_t k = 0; k < read.size(); ++k)
      ASSERT_EQ(read[k].data, noise(COUNT, k).data) << limit;
    if (!read.empty())
    {
      EXPECT_EQ(loss->end, ros::Time(1 + (read.size() - 1) / 4, (read.size() - 1) % 4 * 250'000'000));
    }
  }
}

TEST(BagFile, makesRoomForItsIndex)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "a.bag";
  BagFile file(path);
  for (std::uint32_t k = 0; k < 10; ++k)
    file.write("/noise", ros::Time(1 + k, 0), noise(50, k));
  std::optional<BagFile::Loss> loss;
  {
    const std::uint64_t unpacked = file.size();  // waits until all finished chunks are in the file
    const FileSizeLimit full(std::filesystem::file_size(path));
    ASSERT_GT(unpacked, std::filesystem::file_size(path));
    loss = file.close();
  }
  ASSERT_TRUE(loss);
  EXPECT_NO_THROW(requireSoundBag(path));
  const auto read = readNoise(path);
  ASSERT_GT(read.size(), 4u);
  EXPECT_LT(read.size(), 9u);
  for (std::uint32_t k = 0; k < read.size(); ++k)
    EXPECT_EQ(read[k].data, noise(50, k).data);
  EXPECT_EQ(loss->end, ros::Time(static_cast<std::uint32_t>(read.size()), 0));
}

TEST(BagFile, isRefusedWhereNothingFits)
{
  const ScratchDirectory scratch;
  std::filesystem::create_symlink("/dev/full", scratch / "a.bag");
  try
  {
    BagFile file(scratch / "a.bag");
    FAIL() << "opened";
  }
  catch (const BagError& error)
  {
    EXPECT_STREQ(error.what(), "No space left on device");
  }
  EXPECT_TRUE(scratch.empty());
}
}  // namespace
}  // namespace ratchet_sieve
