#pragma once

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/node_handle.h>
#include <rosgraph_msgs/Log.h>

#include "waiting.h"

namespace ratchet_sieve
{

/// The last of each status on /diagnostics.
class Statuses
{
public:
  explicit Statuses(ros::NodeHandle& node)
      : subscriber_(node.subscribe<diagnostic_msgs::DiagnosticArray>(
            "/diagnostics", 100,
            [this](const diagnostic_msgs::DiagnosticArray::ConstPtr& array)
            {
              for (const auto& status : array->status)
                last_[status.name] = status;
            }))
  {
  }

  const diagnostic_msgs::DiagnosticStatus& operator[](const std::string& name) { return last_[name]; }

  /// Waits until a status has this level and contains the words.
  bool waitFor(const std::string& name, std::uint8_t level, const std::string& words = "")
  {
    return ratchet_sieve::waitFor(
        [&]
        {
          const auto found = last_.find(name);
          return found != last_.end() && found->second.level == level &&
                 found->second.message.find(words) != std::string::npos;
        });
  }

  /// One of its values; empty if there is none.
  std::string value(const std::string& name, const std::string& key)
  {
    for (const auto& entry : last_[name].values)
      if (entry.key == key)
        return entry.value;
    return "";
  }

private:
  std::map<std::string, diagnostic_msgs::DiagnosticStatus> last_;
  ros::Subscriber subscriber_;
};

/// Collects the log lines of a node from /rosout.
class NodeLog
{
public:
  explicit NodeLog(const std::string& node)
  {
    ros::NodeHandle handle;
    subscriber_ = handle.subscribe<rosgraph_msgs::Log>("/rosout", 10000,
                                                       [this, node](const rosgraph_msgs::Log::ConstPtr& line)
                                                       {
                                                         if (line->name == node)
                                                           lines.push_back(line->msg);
                                                       });
  }

  /// Number of lines that contain the words.
  std::ptrdiff_t count(const std::string& words) const
  {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const std::string& line) { return line.find(words) != std::string::npos; });
  }

  std::vector<std::string> lines;

private:
  ros::Subscriber subscriber_;
};

}  // namespace ratchet_sieve
