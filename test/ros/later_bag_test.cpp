// Bags of a later version with other messages.
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>

#include "collecting_sink.h"
#include "errors.h"
#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/ros/bag.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
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

TEST(LaterBag, IsRefusedByTypeAndVersions)
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
  const auto reading_error = [&path]
  {
    CollectingSink read;
    return errorOf([&] { readBags({path}, read); });
  };
  const std::string program = std::string("that ratchet_sieve ") + version() + " does not know";
  EXPECT_EQ(reading_error(), path + ": /sieve/bins has a ratchet_sieve/BinCounts " + program +
                                 ", recorded by ratchet_sieve 1234.5.6");
  file.open(path, rosbag::bagmode::Write);
  file.write("/sieve/scene", ros::TIME_MIN, unknown(toMessage(scene)));
  file.close();
  EXPECT_EQ(reading_error(), path + ": /sieve/scene has a ratchet_sieve/SceneDescription " + program);
}

}  // namespace
}  // namespace ratchet_sieve
