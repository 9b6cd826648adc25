#include <cstdio>
#include <string>

#include <rosbag/bag.h>

#include "ratchet_sieve/recording/frame_sampler.h"
#include "ratchet_sieve/ros/conversions.h"
#include "ratchet_sieve/scene/scene_file.h"

/// Writes small bags of one run into a directory, one for each way in which rosbag packs.
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

/// As BagWriter writes, but without the definitions of the messages, which nothing here reads: they
/// would be most of the bag.
class SeedBag : public FrameSink
{
public:
  SeedBag(const std::string& path, rosbag::CompressionType compression) : bag_(path, rosbag::bagmode::Write)
  {
    bag_.setCompression(compression);
    bag_.setChunkThreshold(1500);
  }

  void take(const SceneFrame& frame) override { write("/sieve/scene", toMessage(frame)); }
  void take(const ParticleFrame& frame) override { write("/sieve/particles", toMessage(frame)); }
  void take(const BinFrame& frame) override { write("/sieve/bins", toMessage(frame)); }
  void take(const BaseFrame& frame) override { write("/sieve/base", toMessage(frame)); }
  void take(const StatisticsFrame& frame) override { write("/sieve/statistics", toMessage(frame)); }

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

void writeSeed(const std::string& path, rosbag::CompressionType compression)
{
  Simulation simulation(sceneFromText(SCENE, "seed").definition);
  SeedBag bag(path, compression);
  FrameSampler sampler({40.0, 20.0, 20.0, 20.0}, 0.0);
  sampler.takeDue(simulation, bag);
  while (simulation.time() < simulation.scene().duration)
  {
    simulation.advanceTo(std::min(sampler.nextTime(), simulation.scene().duration));
    sampler.takeDue(simulation, bag);
  }
  sampler.takeLast(simulation, bag);
}

}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fputs("Usage: bag_seeds DIRECTORY\n", stderr);
    return 2;
  }
  const std::string directory = argv[1];
  ratchet_sieve::writeSeed(directory + "/none.bag", rosbag::compression::Uncompressed);
  ratchet_sieve::writeSeed(directory + "/bz2.bag", rosbag::compression::BZ2);
  ratchet_sieve::writeSeed(directory + "/lz4.bag", rosbag::compression::LZ4);
  return 0;
}
