#pragma once

#include <map>
#include <string>

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/ros.h>

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

private:
  std::map<std::string, diagnostic_msgs::DiagnosticStatus> last_;
  ros::Subscriber subscriber_;
};

}  // namespace ratchet_sieve
