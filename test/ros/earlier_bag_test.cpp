// Bags of before ParticleStates.radius existed, when all disks of a species were equal.
#include <algorithm>
#include <string>

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
/// A message with the fields of that time. Its definition's checksum by genmsg is EARLIER_CHECKSUM.
struct EarlierParticles
{
  ParticleStates fields;
};

constexpr const char* EARLIER_CHECKSUM = "adb6351783fa1df73aef027d3828d669";
constexpr const char* EARLIER_DEFINITION =
    "Header header\nfloat64 time\nuint32[] id\nuint32[] species\nfloat64[] x\nfloat64[] y\nfloat64[] angle\n"
    "float64[] vx\nfloat64[] vy\nfloat64[] spin\nfloat64[] displacement\n"
    "================================================================================\n"
    "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id\n";
}  // namespace
}  // namespace ratchet_sieve

namespace ros
{
namespace message_traits
{
template <>
struct MD5Sum<ratchet_sieve::EarlierParticles>
{
  static const char* value(const ratchet_sieve::EarlierParticles& = {})
  {
    return ratchet_sieve::EARLIER_CHECKSUM;
  }
};
template <>
struct DataType<ratchet_sieve::EarlierParticles>
{
  static const char* value(const ratchet_sieve::EarlierParticles& = {})
  {
    return "ratchet_sieve/ParticleStates";
  }
};
template <>
struct Definition<ratchet_sieve::EarlierParticles>
{
  static const char* value(const ratchet_sieve::EarlierParticles& = {})
  {
    return ratchet_sieve::EARLIER_DEFINITION;
  }
};
}  // namespace message_traits

namespace serialization
{
template <>
struct Serializer<ratchet_sieve::EarlierParticles>
{
  template <typename Stream>
  static void write(Stream& stream, const ratchet_sieve::EarlierParticles& message)
  {
    const ratchet_sieve::ParticleStates& m = message.fields;
    stream.next(m.header);
    stream.next(m.time);
    stream.next(m.id);
    stream.next(m.species);
    for (const auto* column : {&m.x, &m.y, &m.angle, &m.vx, &m.vy, &m.spin, &m.displacement})
      stream.next(*column);
  }

  static std::uint32_t serializedLength(const ratchet_sieve::EarlierParticles& message)
  {
    return serializationLength(message.fields) - serializationLength(message.fields.radius);
  }
};
}  // namespace serialization
}  // namespace ros

namespace ratchet_sieve
{
namespace
{
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
      file.write("/sieve/particles", std::max(ros::TIME_MIN, ros::Time(time)),
                 EarlierParticles{toMessage(written.particles.back())});
    }
  }
  CollectingSink read;
  readBag(scratch / "earlier.bag", read);
  EXPECT_EQ(read.particles.size(), 4u);
  EXPECT_FALSE(read.particles.back().disks.empty());
  EXPECT_TRUE(sameBits(read.particles, written.particles));
}
}  // namespace
}  // namespace ratchet_sieve
