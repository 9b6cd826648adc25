// Bags of before a message had its last fields: ParticleStates the radii, BinCounts separation and window.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include "collecting_sink.h"
#include "errors.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/ros/bag.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// A message without its last bytes. @param checksum by genmsg of the type of that time
template <typename Message>
topic_tools::ShapeShifter earlier(const Message& message, const char* checksum, std::size_t missing)
{
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream whole(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(whole, message);
  topic_tools::ShapeShifter shifter;
  shifter.morph(checksum, ros::message_traits::datatype<Message>(), "", "");
  ros::serialization::IStream short_of(bytes.data(), static_cast<std::uint32_t>(bytes.size() - missing));
  shifter.read(short_of);
  return shifter;
}

/// The bins of the type of that time.
struct EarlierBins
{
  const char* checksum;
  std::size_t missing;  ///< bytes; the window's arrays are of two species
  bool separation;
};
constexpr std::size_t WINDOW =
    2 * sizeof(double) + 2 * (sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t)) + 1;
constexpr EarlierBins BINS[] = {{"8cc345b25409bfd727e7181dbe20f1bc", sizeof(double) + 1 + WINDOW, false},
                                {"6ffd59933426132a23002197e6036dc1", WINDOW, true}};

class EarlierBag : public testing::TestWithParam<EarlierBins>
{
};

TEST_P(EarlierBag, IsReadBitForBit)
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
      const ros::Time stamp = std::max(ros::TIME_MIN, ros::Time(time));
      file.write("/sieve/particles", stamp,
                 earlier(toMessage(written.particles.back()), "adb6351783fa1df73aef027d3828d669",
                         sizeof(std::uint32_t)));
      file.write("/sieve/bins", stamp,
                 earlier(toMessage(written.bins.back()), GetParam().checksum, GetParam().missing));
      BinFrame& bins = written.bins.back();
      bins.window_start = 0.0;
      bins.window_left = bins.window_right = {};
      if (!GetParam().separation)
        bins.separation = {};
    }
  }
  CollectingSink read;
  readBags({scratch / "earlier.bag"}, read);
  EXPECT_EQ(read.particles.size(), 4u);
  EXPECT_FALSE(read.particles.back().disks.empty());
  EXPECT_TRUE(sameBits(read.particles, written.particles));
  EXPECT_TRUE(sameBits(read.bins, written.bins));
}

TEST(LaterBag, IsRefusedByTypeAndVersions)
{
  const ScratchDirectory scratch;
  const std::string path = scratch / "later.bag";
  const char* unknown = "0123456789abcdef0123456789abcdef";
  const Simulation simulation(smallMixture());
  SceneFrame scene = makeSceneFrame(simulation);
  scene.version = "1234.5.6";
  rosbag::Bag file(path, rosbag::bagmode::Write);
  file.write("/sieve/scene", ros::TIME_MIN, toMessage(scene));
  file.write("/sieve/bins", ros::TIME_MIN, earlier(toMessage(makeBinFrame(simulation)), unknown, 0));
  file.close();
  const auto reading_error = [&path]
  {
    CollectingSink read;
    return errorOf([&] { readBags({path}, read); });
  };
  const std::string program = std::string("that ratchet_sieve ") + version() + " does not know";
  EXPECT_EQ(reading_error(), path + ": /sieve/bins has a ratchet_sieve/BinCounts " + program +
                                 ", recorded by ratchet_sieve 1234.5.6");
  file.open(path, rosbag::bagmode::Write);
  file.write("/sieve/scene", ros::TIME_MIN, earlier(toMessage(scene), unknown, 0));
  file.close();
  EXPECT_EQ(reading_error(), path + ": /sieve/scene has a ratchet_sieve/SceneDescription " + program);
}

INSTANTIATE_TEST_SUITE_P(Bins, EarlierBag, testing::ValuesIn(BINS));
}  // namespace
}  // namespace ratchet_sieve
