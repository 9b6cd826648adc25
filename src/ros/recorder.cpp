#include "recorder.h"

#include <filesystem>

#include <ros/console.h>

namespace ratchet_sieve
{
namespace
{
constexpr double BYTES_PER_MB = 1e6;

/// The absolute path, for log lines: roslaunch starts its nodes in ~/.ros.
std::string absolutePath(const std::string& path)
{
  std::error_code error;
  const std::filesystem::path whole = std::filesystem::absolute(path, error);
  return path.empty() || error ? path : whole.string();
}
}  // namespace

Recorder::Recorder(const std::string& path, const std::string& topic_prefix,
                   const RecordingParameters& parameters, const std::string& frame_id)
    : base_path_(absolutePath(path)),
      topic_prefix_(topic_prefix),
      frame_id_(frame_id),
      parameters_(parameters)
{
}

/// Begins the next file.
void Recorder::openFile()
{
  std::string suffix;
  if (run_ > 1)
    suffix += "_run" + std::to_string(run_);
  if (parameters_.splits())
    suffix += "_" + std::to_string(file_);
  std::filesystem::path path(base_path_);
  path.replace_filename(path.stem().string() + suffix + path.extension().string());
  bag_ = std::make_unique<BagWriter>(path.string(), topic_prefix_, frame_id_);
}

void Recorder::open()
{
  if (!on())
    return;
  ++run_;
  openFile();
}

void Recorder::openNext()
{
  close();
  failure_.clear();
  file_ = 0;
  try
  {
    open();
  }
  catch (const BagError& error)
  {
    giveUp(error);
  }
  if (bag_)
    ROS_INFO("the new run is recorded into %s", bag_->path().c_str());
}

void Recorder::close()
{
  try
  {
    if (bag_)
      bag_->close();
    bag_.reset();
  }
  catch (const BagError& error)
  {
    giveUp(error);
  }
}

/// The error of closing has more information than that of writing: the location of the rest.
void Recorder::giveUp(const BagError& error)
{
  failure_ = error.what();
  try
  {
    if (bag_)
      bag_->close();
  }
  catch (const BagError& closing)
  {
    failure_ = closing.what();
  }
  bag_.reset();
  if (first_failure_.empty())
    first_failure_ = failure_;
  ROS_ERROR("the recording was aborted: %s", failure_.c_str());
}

double Recorder::megabytes() const
{
  return bag_ ? static_cast<double>(bag_->size()) / BYTES_PER_MB : 0.0;
}

bool Recorder::wants(FrameKind kind) const
{
  const auto rate = describe(kind).rate;
  return bag_ != nullptr && (rate == nullptr || parameters_.rates.*rate > 0.0);
}

bool Recorder::full() const
{
  return (parameters_.split_size > 0.0 && megabytes() >= parameters_.split_size) ||
         (parameters_.split_duration > 0.0 && last_time_ >= file_start_ + parameters_.split_duration);
}

void Recorder::splitBefore(double time)
{
  if (!(time > last_time_) || !full())
    return;
  bag_->close();
  ++file_;
  openFile();
  scene_.time = last_time_;
  file_start_ = last_time_;
  bag_->take(scene_);
}

void Recorder::take(const AnyFrame& frame)
{
  if (const SceneFrame* scene = frame.as<SceneFrame>())
  {
    scene_ = *scene;
    file_start_ = last_time_ = scene->time;
  }
  if (!wants(frame.kind()))
    return;
  try
  {
    splitBefore(frame.time());
    bag_->take(frame);
    last_time_ = frame.time();
  }
  catch (const BagError& error)
  {
    giveUp(error);
  }
}

}  // namespace ratchet_sieve
