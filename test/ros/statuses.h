#pragma once

#include <map>
#include <string>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/node_handle.h>

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

}  // namespace ratchet_sieve
