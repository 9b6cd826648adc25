#include "ratchet_sieve/ros/bag.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include <unistd.h>

#include <ros/console.h>
#include <std_msgs/Float64.h>

#include "bag_file.h"
#include "ratchet_sieve/live/setpoint.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
BagError cannotBeWritten(const std::string& path, const std::string& why)
{
  return BagError(path + ": cannot be written: " + why);
}

/// Anything that is not a regular file is refused: a directory cannot be a bag, and a device would be
/// replaced.
/// @throws BagError
void requireNothingOrFile(const std::string& path)
{
  std::error_code none;
  const std::filesystem::file_status status = std::filesystem::status(path, none);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw BagError("it exists and is not a regular file");
  if (LockedFile::isLocked(path))
    throw BagError("another program is writing it");
}

/// Whether a file is a bag that was closed, or reindexed.
bool isIndexedBag(const std::string& path)
{
  try
  {
    const rosbag::Bag bag(path);
    return true;
  }
  catch (const std::exception&)  // where it is damaged, also of lengths that are none
  {
    return false;
  }
}

/// An unused file name.
std::string unfinishedPath(const std::string& path)
{
  const std::string stem = path + ".unfinished";
  std::string name = stem + ".active";
  std::error_code none;
  for (int k = 2; std::filesystem::exists(std::filesystem::symlink_status(name, none)); ++k)
    name = stem + std::to_string(k) + ".active";
  return name;
}

/// Renames a recording that was not closed. It contains all but its index and must not be overwritten.
/// @throws BagError
void setAside(const std::string& path, const std::string& active_path)
{
  std::error_code none;
  if (!std::filesystem::is_regular_file(active_path, none))
    return;
  if (LockedFile::isLocked(active_path) || access(active_path.c_str(), R_OK | W_OK) != 0)
    return;  // BagFile reports the error
  const std::string unfinished = unfinishedPath(path);
  const bool indexed = isIndexedBag(active_path);
  if (std::rename(active_path.c_str(), unfinished.c_str()) != 0)
    throw BagError("there is " + active_path +
                   ", which was not closed and cannot be renamed: " + std::strerror(errno));
  const std::string advice =
      indexed ? "it has an index and can be read" : "`rosbag reindex " + unfinished + "` adds its index";
  ROS_WARN("%s was left by a program that was killed: renamed to %s; %s", active_path.c_str(),
           unfinished.c_str(), advice.c_str());
}

std::unique_ptr<BagFile> opened(const std::string& path, const std::string& active_path)
{
  try
  {
    requireNothingOrFile(path);
    setAside(path, active_path);
    return std::make_unique<BagFile>(active_path);
  }
  catch (const BagError& error)
  {
    throw cannotBeWritten(path, error.what());
  }
}
}  // namespace

BagWriter::BagWriter(const std::string& path, const std::string& topic_prefix, const std::string& frame_id)
    : path_(linkTarget(path)),
      active_path_(path_ + ".active"),
      topic_prefix_(topic_prefix),
      frame_id_(frame_id),
      file_(opened(path_, active_path_))
{
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
  if (!file_)
    return;
  const std::unique_ptr<BagFile> file = std::move(file_);
  if (!file->hasBegun())
    std::remove(active_path_.c_str());
  std::optional<BagFile::Loss> loss;
  try
  {
    loss = file->close();
  }
  catch (const BagError& error)
  {
    throw cannotBeWritten(
        path_,
        error.what() + (file->hasBegun() ? "; the bag is " + active_path_ + ", for `rosbag reindex`" : ""));
  }
  if (file->hasBegun() && std::rename(active_path_.c_str(), path_.c_str()) != 0)
    throw BagError(path_ + ": the bag cannot be renamed to it: " + std::strerror(errno) + "; the bag is " +
                   active_path_);
  if (loss)
  {
    const std::string end = "; the bag ends at " + std::to_string(loss->end.toSec()) + " s";
    throw cannotBeWritten(path_, loss->reason + (file->hasBegun() ? end : ""));
  }
}

std::uint64_t BagWriter::size() const
{
  return file_ ? file_->size() : 0;
}

template <typename Message>
void BagWriter::write(const std::string& topic, double time, const Message& message, bool latched)
{
  if (!file_)
    throw cannotBeWritten(path_, "it is closed");
  try
  {
    file_->write(topic_prefix_ + "/" + topic, std::max(ros::Time(time), ros::TIME_MIN), message, latched);
  }
  catch (const BagError& error)
  {
    throw cannotBeWritten(path_, error.what());
  }
}

void BagWriter::take(const AnyFrame& any)
{
  const bool latched = any.kind() == FrameKind::SCENE;
  any.visit(
      [&](const auto& frame)
      {
        auto message = toMessage(frame, frame_id_);
        message.header.seq = written_[any.kind()]++;
        write(describe(any.kind()).name, frame.time, message, latched);
      });
  if (const CommandFrame* command = any.as<CommandFrame>())
    writeSetpoint(*command);
}

void BagWriter::writeSetpoint(const CommandFrame& command)
{
  const auto quantity = setpointQuantity(command.kind);
  if (!quantity)
    return;
  std_msgs::Float64 message;
  message.data = command.values.at(0);
  write(setpointTopic(*quantity), command.time, message);
}

}  // namespace ratchet_sieve
