#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <ros/console.h>

namespace ratchet_sieve
{

/// Captures this process's log lines at WARN and above: ROS libraries log errors that they do not return.
class CaughtLog : public ros::console::LogAppender
{
public:
  CaughtLog() { ros::console::register_appender(this); }
  ~CaughtLog() override { ros::console::deregister_appender(this); }
  CaughtLog(const CaughtLog&) = delete;
  CaughtLog& operator=(const CaughtLog&) = delete;

  void log(ros::console::Level level, const char* text, const char*, const char*, int) override
  {
    if (level < ros::console::levels::Warn)
      return;
    const std::lock_guard<std::mutex> lock(mutex_);
    lines_.emplace_back(text);
  }

  /// @return the lines that contain the words
  std::vector<std::string> with(const std::string& words) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::string> found;
    for (const std::string& line : lines_)
      if (line.find(words) != std::string::npos)
        found.push_back(line);
    return found;
  }

private:
  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
};

}  // namespace ratchet_sieve
