// Bags of before a message had its last fields: ParticleStates its radii, BinCounts its separation.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rosbag/bag.h>

#include "collecting_sink.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/ros/bag_reader.h"
#include "ratchet_sieve/ros/conversions.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// A message that is written without its last fields.
template <typename Message>
struct Earlier
{
  Message message;
};

/// The checksum by genmsg of the type of that time, and the bytes that its messages lack.
template <typename Message>
constexpr const char* CHECKSUM = "adb6351783fa1df73aef027d3828d669";
template <>
constexpr const char* CHECKSUM<BinCounts> = "8cc345b25409bfd727e7181dbe20f1bc";

template <typename Message>
constexpr std::uint32_t MISSING = sizeof(std::uint32_t);
template <>
constexpr std::uint32_t MISSING<BinCounts> = sizeof(double) + 1;
}  // namespace
}  // namespace ratchet_sieve

namespace ros
{
namespace message_traits
{
template <typename Message>
struct MD5Sum<ratchet_sieve::Earlier<Message>>
{
  static const char* value(const ratchet_sieve::Earlier<Message>& = {})
  {
    return ratchet_sieve::CHECKSUM<Message>;
  }
};
template <typename Message>
struct DataType<ratchet_sieve::Earlier<Message>> : DataType<Message>
{
  static const char* value(const ratchet_sieve::Earlier<Message>& = {}) { return DataType<Message>::value(); }
};
template <typename Message>
struct Definition<ratchet_sieve::Earlier<Message>>
{
  static const char* value(const ratchet_sieve::Earlier<Message>& = {}) { return ""; }
};
}  // namespace message_traits

namespace serialization
{
template <typename Message>
struct Serializer<ratchet_sieve::Earlier<Message>>
{
  template <typename Stream>
  static void write(Stream& stream, const ratchet_sieve::Earlier<Message>& earlier)
  {
    std::vector<std::uint8_t> bytes(serializationLength(earlier.message));
    OStream whole(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    serialize(whole, earlier.message);
    std::copy_n(bytes.begin(), serializedLength(earlier), stream.advance(serializedLength(earlier)));
  }

  static std::uint32_t serializedLength(const ratchet_sieve::Earlier<Message>& earlier)
  {
    return serializationLength(earlier.message) - ratchet_sieve::MISSING<Message>;
  }
};
}  // namespace serialization
}  // namespace ros

namespace ratchet_sieve
{
namespace
{
template <typename Frame>
auto earlier(const Frame& frame)
{
  return Earlier<MessageOf<Frame>>{toMessage(frame)};
}

TEST(EarlierBag, IsReadBitForBit)
{
  const ScratchDirectory scratch;
  Simulation simulation(smallMixture());
  CollectingSink written;
  {
    rosbag::Bag file(scratch / "earlier.bag", rosbag::bagmode::Write);
    file.write("/sieve/scene", ros::TIME_MIN, toMessage(makeSceneFrame(simulation)));
    for (const double time : {0.0, 0.1, 0.2, 0.3})
    {
      simulation.advanceTo(time);
      written.take(makeParticleFrame(simulation));
      written.take(makeBinFrame(simulation));
      written.bins.back().separation = {};
      const ros::Time stamp = std::max(ros::TIME_MIN, ros::Time(time));
      file.write("/sieve/particles", stamp, earlier(written.particles.back()));
      file.write("/sieve/bins", stamp, earlier(written.bins.back()));
    }
  }
  CollectingSink read;
  readBag(scratch / "earlier.bag", read);
  EXPECT_EQ(read.particles.size(), 4u);
  EXPECT_FALSE(read.particles.back().disks.empty());
  EXPECT_TRUE(sameBits(read.particles, written.particles));
  EXPECT_TRUE(sameBits(read.bins, written.bins));
}
}  // namespace
}  // namespace ratchet_sieve
