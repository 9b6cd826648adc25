#include "ratchet_sieve/ros/bag_writer.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <ros/console.h>
#include <std_msgs/Float64.h>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
/// Where a setpoint comes in; null for what is none.
const char* setpointTopic(CommandKind kind)
{
  switch (kind)
  {
    case CommandKind::INCLINATION:
      return "inclination_setpoint";
    case CommandKind::FREQUENCY:
      return "frequency_setpoint";
    case CommandKind::AMPLITUDE:
      return "amplitude_setpoint";
    default:
      return nullptr;
  }
}

/// What makes `rosbag play` latch a topic, as the node does, for those who come late.
template <typename Message>
boost::shared_ptr<ros::M_string> latchedHeader()
{
  namespace traits = ros::message_traits;
  const ros::M_string fields = {{"type", traits::datatype<Message>()},
                                {"md5sum", traits::md5sum<Message>()},
                                {"message_definition", traits::definition<Message>()},
                                {"latching", "1"}};
  return boost::make_shared<ros::M_string>(fields);
}
}  // namespace

BagWriter::BagWriter(const std::string& path, const std::string& topic_prefix)
    : path_(path), active_path_(path + ".active"), topic_prefix_(topic_prefix)
{
  try
  {
    bag_.open(active_path_, rosbag::bagmode::Write);
    bag_.setCompression(rosbag::compression::LZ4);
  }
  catch (const rosbag::BagException& error)
  {
    throw BagError(path_ + ": cannot be written: " + error.what());
  }
}

BagWriter::~BagWriter()
{
  try
  {
    close();
  }
  catch (const BagError& error)
  {
    ROS_ERROR("%s", error.what());
  }
}

void BagWriter::close()
{
  if (!bag_.isOpen())
    return;
  try
  {
    bag_.close();
  }
  catch (const rosbag::BagException& error)
  {
    throw BagError(path_ + ": cannot be closed: " + error.what());
  }
  if (std::rename(active_path_.c_str(), path_.c_str()) != 0)
    throw BagError(path_ + ": cannot be named so: " + std::strerror(errno) + "; the bag is " + active_path_);
}

template <typename Message>
void BagWriter::write(const char* topic, double time, const Message& message,
                      const boost::shared_ptr<ros::M_string>& connection_header)
{
  try
  {
    bag_.write(topic_prefix_ + "/" + topic, std::max(stampOf(time), ros::TIME_MIN), message,
               connection_header);
  }
  catch (const rosbag::BagException& error)
  {
    throw BagError(path_ + ": cannot be written: " + error.what());
  }
}

void BagWriter::take(const SceneFrame& frame)
{
  write("scene", frame.time, toMessage(frame), latchedHeader<SceneDescription>());
}

void BagWriter::take(const ParticleFrame& frame)
{
  write("particles", frame.time, toMessage(frame));
}

void BagWriter::take(const BinFrame& frame)
{
  write("bins", frame.time, toMessage(frame));
}

void BagWriter::take(const BaseFrame& frame)
{
  write("base", frame.time, toMessage(frame));
}

void BagWriter::take(const StatisticsFrame& frame)
{
  write("statistics", frame.time, toMessage(frame));
}

void BagWriter::take(const CommandFrame& frame)
{
  write("commands", frame.time, toMessage(frame));
  const char* topic = setpointTopic(frame.kind);
  if (topic == nullptr)
    return;
  std_msgs::Float64 message;
  message.data = frame.values.at(0);
  write(topic, frame.time, message);
}

}  // namespace ratchet_sieve
