#include <cstring>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <rosbag/bag.h>

#include "collecting_sink.h"
#include "ratchet_sieve/recording/frame_sampler.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "ratchet_sieve/ros/conversions.h"
#include "small_scenes.h"

/// Bags with bytes changed by hand: each is refused with one line.
namespace ratchet_sieve
{
namespace
{

/// The bytes of a bag of one scene and some particles, in two chunks.
std::string bagBytes(rosbag::CompressionType compression)
{
  const ScratchDirectory scratch;
  const Simulation simulation(smallMixture());
  {
    rosbag::Bag bag(scratch / "run.bag", rosbag::bagmode::Write);
    bag.setCompression(compression);
    bag.setChunkThreshold(5000);
    bag.write("/sieve/scene", ros::Time(1.0), toMessage(makeSceneFrame(simulation)));
    for (int k = 0; k < 5; ++k)
      bag.write("/sieve/particles", ros::Time(1.0 + k), toMessage(makeParticleFrame(simulation)));
  }
  return contents(scratch / "run.bag");
}

/// Empty if the bytes are read as a run.
std::string refusalOfBytes(const std::string& bytes)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "b";
  std::ofstream(path, std::ios::binary) << bytes;
  CollectingSink sink;
  try
  {
    readBag(path, sink);
  }
  catch (const BagError& error)
  {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return std::string(error.what()).substr(path.size() + 2);
  }
  return "";
}

template <typename T>
std::string bytesOf(T value)
{
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// The bag with the value of a field overwritten; the first field of that name, or the last.
std::string withField(std::string bag, const std::string& name, const std::string& value, bool last = false)
{
  const std::size_t at = last ? bag.rfind(name + "=") : bag.find(name + "=");
  return bag.replace(at + name.size() + 1, value.size(), value);
}

constexpr std::uint32_t HUGE_NUMBER = 0xfffffff0;

TEST(DamagedBag, IsReadAsLongAsItIsNone)
{
  for (const auto compression :
       {rosbag::compression::Uncompressed, rosbag::compression::BZ2, rosbag::compression::LZ4})
    EXPECT_EQ(refusalOfBytes(bagBytes(compression)), "");
}

TEST(DamagedBag, ThatBeginsAsAnotherFileIsRefused)
{
  const std::string whole = bagBytes(rosbag::compression::LZ4);
  const std::string none = "cannot be read as a bag: it is not of format 2.0";
  EXPECT_EQ(refusalOfBytes(""), none);
  EXPECT_EQ(refusalOfBytes("#ROSBAG V1.2\n" + whole.substr(13)), none);
  EXPECT_EQ(refusalOfBytes("#ROS" + std::string(1000, 'x') + " V2.0\n"), none);
}

TEST(DamagedBag, WhoseHeaderPointsNowhereIsRefused)
{
  const std::string whole = bagBytes(rosbag::compression::LZ4);
  const std::string unclosed = "was not closed, or is damaged: try `rosbag reindex`";
  EXPECT_EQ(refusalOfBytes(withField(whole, "index_pos", bytesOf<std::uint64_t>(0))), unclosed);
  EXPECT_EQ(refusalOfBytes(withField(whole, "index_pos", bytesOf<std::uint64_t>(whole.size() + 1))),
            unclosed);
  EXPECT_NE(refusalOfBytes(withField(whole, "index_pos", bytesOf<std::uint64_t>(5000))), "");
  EXPECT_NE(refusalOfBytes(withField(whole, "chunk_count", bytesOf(HUGE_NUMBER))), "");
  EXPECT_NE(refusalOfBytes(withField(whole, "chunk_count", bytesOf(1u))), "");
  EXPECT_NE(refusalOfBytes(withField(whole, "conn_count", bytesOf(HUGE_NUMBER))), "");
  EXPECT_NE(refusalOfBytes(withField(whole, "conn_count", bytesOf(1u))), "");
  EXPECT_NE(refusalOfBytes(whole + "more"), "");
}

TEST(DamagedBag, WhoseChunkIsNotWhatItSaysIsRefused)
{
  const std::string damage = "cannot be read as a bag: ";
  for (const auto compression : {rosbag::compression::BZ2, rosbag::compression::LZ4})
  {
    const std::string whole = bagBytes(compression);
    EXPECT_EQ(refusalOfBytes(withField(whole, "size", bytesOf(HUGE_NUMBER))),
              damage + "its declared uncompressed size is too large");
    EXPECT_EQ(refusalOfBytes(withField(whole, "size", bytesOf(1u << 20))),
              damage + "a chunk cannot be decompressed");
    EXPECT_EQ(refusalOfBytes(withField(whole, "size", bytesOf(100u))),
              damage + "a chunk cannot be decompressed");
    EXPECT_EQ(refusalOfBytes(withField(whole, "compression", "xyz")),
              damage + "a chunk has an unknown compression");
  }
  EXPECT_EQ(
      refusalOfBytes(withField(bagBytes(rosbag::compression::Uncompressed), "size", bytesOf(HUGE_NUMBER))),
      damage + "its declared uncompressed size is too large");
  EXPECT_EQ(refusalOfBytes(withField(bagBytes(rosbag::compression::Uncompressed), "size", bytesOf(100u))),
            damage + "the size of a chunk differs from its header");
}

TEST(DamagedBag, WhoseIndexLeadsAstrayIsRefused)
{
  const std::string whole = bagBytes(rosbag::compression::LZ4);
  const std::string damage = "cannot be read as a bag: ";
  EXPECT_EQ(refusalOfBytes(withField(whole, "ver", bytesOf(7u))),
            damage + "an index is of an unknown version");
  EXPECT_EQ(refusalOfBytes(withField(whole, "chunk_pos", bytesOf<std::uint64_t>(1), true)),
            damage + "its information on a chunk does not match the chunk");
  // An index record: the last field of its header, the length of the data, then seconds, nanoseconds, offset.
  const std::size_t entry = whole.find("ver=") + 4 + 4 + 4;
  for (const std::uint32_t offset : {1u, HUGE_NUMBER})
    EXPECT_EQ(refusalOfBytes(std::string(whole).replace(entry + 8, 4, bytesOf(offset))),
              damage + "an index entry points to no message");
  EXPECT_EQ(refusalOfBytes(std::string(whole).replace(entry + 4, 4, bytesOf(HUGE_NUMBER))),
            damage + "an index has an invalid time");
  EXPECT_EQ(refusalOfBytes(std::string(whole).replace(entry, 8, 8, '\0')),
            damage + "an index has an invalid time");
}

TEST(DamagedBag, WhoseIndexNamesAMessageTwiceIsRefused)
{
  const std::string whole = bagBytes(rosbag::compression::LZ4);
  // The second index record is that of the particles; the first chunk has several of them.
  const std::size_t record = whole.find("ver=", whole.find("ver=") + 1);
  const std::size_t first_offset = record + 4 + 4 + 4 + 8;
  EXPECT_EQ(refusalOfBytes(std::string(whole).replace(first_offset + 12, 4, whole, first_offset, 4)),
            "cannot be read as a bag: an index entry points to no message");
}

template <typename T>
T valueAt(const std::string& bytes, std::size_t at)
{
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

TEST(DamagedBag, WhoseIndexLeavesAMessageOutIsRefused)
{
  std::string bag = bagBytes(rosbag::compression::LZ4);
  const auto index_position = valueAt<std::uint64_t>(bag, bag.find("index_pos=") + 10);
  // Removes the last entry of the last index record, and corrects everything that counts it.
  const std::size_t length = bag.rfind("ver=", index_position) + 8;
  const std::size_t count = bag.rfind("count=", length) + 6;
  bag.replace(count, 4, bytesOf(valueAt<std::uint32_t>(bag, count) - 1));
  bag.replace(length, 4, bytesOf(valueAt<std::uint32_t>(bag, length) - 12));
  bag.erase(index_position - 12, 12);
  EXPECT_EQ(refusalOfBytes(withField(bag, "index_pos", bytesOf(index_position - 12))),
            "cannot be read as a bag: messages are missing from an index");
}

/// Chunks of zeros: each takes a few bytes and decompresses to a megabyte.
TEST(DamagedBag, ThatUnpacksToFarMoreThanItsSizeIsRefused)
{
  const ScratchDirectory scratch;
  {
    rosbag::Bag bag(scratch / "bomb.bag", rosbag::bagmode::Write);
    bag.setCompression(rosbag::compression::BZ2);
    SceneFrame scene;
    scene.yaml.assign(1 << 20, ' ');
    for (int k = 0; k < 40; ++k)
      bag.write("/sieve/scene", ros::Time(1.0), toMessage(scene));
  }
  const std::string bytes = contents(scratch / "bomb.bag");
  EXPECT_LT(bytes.size(), 50'000u);
  EXPECT_EQ(refusalOfBytes(bytes), "cannot be read as a bag: its declared uncompressed size is too large");
}

/// Two chunks of some hundred kilobytes whose messages alternate in time.
TEST(DamagedBag, WhoseMessagesAlternateBetweenChunksIsRefused)
{
  const ScratchDirectory scratch;
  const Simulation simulation(smallMixture());
  const auto bag_of = [&](std::uint32_t step)
  {
    {
      rosbag::Bag bag(scratch / "run.bag", rosbag::bagmode::Write);
      bag.write("/sieve/scene", ros::Time(1.0), toMessage(makeSceneFrame(simulation)));
      bag.setChunkThreshold(300'000);
      // Messages of even times first, then those of odd times; with step 1, all in order.
      for (std::uint32_t part = 0; part < step; ++part)
        for (std::uint32_t k = part; k < 800; k += step)
          bag.write("/sieve/particles", ros::Time(2 + k, 0), toMessage(makeParticleFrame(simulation)));
    }
    return contents(scratch / "run.bag");
  };
  EXPECT_EQ(refusalOfBytes(bag_of(1)), "");
  EXPECT_EQ(
      refusalOfBytes(bag_of(2)).rfind("cannot be read as a bag: its messages alternate between chunks; ", 0),
      0u);
}

TEST(DamagedBag, WithAFrameAtNoTimeIsRefused)
{
  for (const double time : {-1.0, 1e10, std::numeric_limits<double>::quiet_NaN()})
  {
    SceneDescription scene;
    scene.time = time;
    const ScratchDirectory scratch;
    rosbag::Bag bag(scratch / "b", rosbag::bagmode::Write);
    bag.write("/sieve/scene", ros::Time(1.0), scene);
    bag.close();
    EXPECT_EQ(refusalOfBytes(contents(scratch / "b")), "/sieve/scene has a message with an invalid time");
  }
}

RC_GTEST_PROP(DamagedBag, IsReadOrRefusedWhereverItsBytesAreChanged, ())
{
  static const std::string BAGS[] = {bagBytes(rosbag::compression::Uncompressed),
                                     bagBytes(rosbag::compression::BZ2), bagBytes(rosbag::compression::LZ4)};
  std::string bag = BAGS[*rc::gen::inRange(0, 3)];
  const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(bag.size()) - 4));
  bag.replace(at, 4, bytesOf(*rc::gen::element(0u, 1u, 0x20000001u, 0x7fffffffu, 0x80000000u, HUGE_NUMBER)));
  refusalOfBytes(bag);
}

}  // namespace
}  // namespace ratchet_sieve
