#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <rosbag/bag.h>

#include "ratchet_sieve/recording/frame_sampler.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/scene/scene_file.h"

/// Writes the seed inputs of the fuzzers of bags and messages: one small run as bags, one per compression of
/// rosbag, and as messages only.
namespace ratchet_sieve
{
namespace
{

constexpr const char* SCENE = R"(
base: {teeth: 2}
boundary: open
species: [{name: A, count: 2, radius: 0.001, mass: 0.010}, {name: B, count: 1, radius: 0.002, mass: 0.001}]
duration: 0.1
)";

/// As BagWriter, but without the message definitions, which are not read here and would be most of the bag.
class SeedBag : public FrameSink
{
public:
  SeedBag(const std::string& path, rosbag::CompressionType compression) : bag_(path, rosbag::bagmode::Write)
  {
    bag_.setCompression(compression);
    // Several chunks, but only one for bz2, which takes milliseconds per chunk.
    if (compression != rosbag::compression::BZ2)
      bag_.setChunkThreshold(1500);
  }

  void take(const AnyFrame& any) override
  {
    const std::string topic = std::string("/sieve/") + describe(any.kind()).name;
    any.visit([&](const auto& frame) { write(topic, toMessage(frame)); });
  }

private:
  template <typename Message>
  void write(const std::string& topic, const Message& message)
  {
    auto connection = boost::make_shared<ros::M_string>();
    (*connection)["type"] = ros::message_traits::datatype<Message>();
    (*connection)["md5sum"] = ros::message_traits::md5sum<Message>();
    (*connection)["message_definition"] = "";
    bag_.write(topic, std::max(message.header.stamp, ros::TIME_MIN), message, connection);
  }

  rosbag::Bag bag_;
};

/// In the format of message_fuzz.
class SeedMessages : public FrameSink
{
public:
  explicit SeedMessages(const std::string& path) : file_(path, std::ios::binary) {}

  void take(const AnyFrame& any) override
  {
    any.visit([&](const auto& frame) { write(any.kind(), toMessage(frame)); });
  }

private:
  template <typename Message>
  void write(FrameKind kind, const Message& message)
  {
    std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(message));
    ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
    ros::serialization::serialize(stream, message);
    file_.put(static_cast<char>(kind));
    file_.put(static_cast<char>(bytes.size() % 256)).put(static_cast<char>(bytes.size() / 256));
    file_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }

  std::ofstream file_;
};

void showRun(FrameSink& sink)
{
  Simulation simulation(sceneFromText(SCENE, "seed").definition);
  FrameSampler sampler({40.0, 20.0, 20.0, 20.0}, 0.0);
  sampler.takeDue(simulation, sink);
  while (simulation.time() < simulation.scene().duration)
  {
    simulation.advanceTo(std::min(sampler.nextTime(), simulation.scene().duration));
    sampler.takeDue(simulation, sink);
  }
  sampler.takeLast(simulation, sink);
}

void writeBag(const std::string& path, rosbag::CompressionType compression)
{
  SeedBag bag(path, compression);
  showRun(bag);
}

void writeMessages(const std::string& path)
{
  SeedMessages messages(path);
  showRun(messages);
}

}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  const std::string what = argc == 3 ? argv[1] : "";
  const std::string directory = argc == 3 ? argv[2] : "";
  if (what == "bags")
  {
    ratchet_sieve::writeBag(directory + "/none.bag", rosbag::compression::Uncompressed);
    ratchet_sieve::writeBag(directory + "/bz2.bag", rosbag::compression::BZ2);
    ratchet_sieve::writeBag(directory + "/lz4.bag", rosbag::compression::LZ4);
    return 0;
  }
  if (what == "messages")
  {
    ratchet_sieve::writeMessages(directory + "/run");
    return 0;
  }
  std::fputs("Usage: bag_seeds bags|messages DIRECTORY\n", stderr);
  return 2;
}
