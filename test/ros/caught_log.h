#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <console_bridge/console.h>
#include <ros/console.h>

namespace ratchet_sieve
{

/// Captures this process's log lines at WARN and above, since ROS libraries log errors that they do not
/// return; and those of tf2, which do not go to ROS's log.
class CaughtLog : public ros::console::LogAppender, public console_bridge::OutputHandler
{
public:
  CaughtLog()
  {
    ros::console::register_appender(this);
    console_bridge::useOutputHandler(this);
  }
  ~CaughtLog() override
  {
    console_bridge::restorePreviousOutputHandler();
    ros::console::deregister_appender(this);
  }
  CaughtLog(const CaughtLog&) = delete;
  CaughtLog& operator=(const CaughtLog&) = delete;

  void log(ros::console::Level level, const char* text, const char*, const char*, int) override
  {
    if (level >= ros::console::levels::Warn)
      add(lines_, text);
  }

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override
  {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN)
      add(of_tf2_, text);
  }

  /// @return the number of lines of ROS that contain the words
  std::size_t count(const std::string& words) const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::size_t found = 0;
    for (const std::string& line : lines_)
      found += line.find(words) != std::string::npos ? 1 : 0;
    return found;
  }

  std::vector<std::string> ofTf2() const
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    return of_tf2_;
  }

private:
  void add(std::vector<std::string>& lines, const std::string& text)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    lines.push_back(text);
  }

  mutable std::mutex mutex_;
  std::vector<std::string> lines_;
  std::vector<std::string> of_tf2_;
};

}  // namespace ratchet_sieve
