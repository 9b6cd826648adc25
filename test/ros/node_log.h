#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <ros/master.h>
#include <ros/node_handle.h>
#include <ros/this_node.h>
#include <rosgraph_msgs/Log.h>

namespace ratchet_sieve
{

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

  /// Whether all nodes that log are connected; a node that already runs connects with a delay.
  bool connected() const
  {
    XmlRpc::XmlRpcValue caller, state, payload;
    caller[0] = ros::this_node::getName();
    if (!ros::master::execute("getSystemState", caller, state, payload, false))
      return false;
    for (int k = 0; k < payload[0].size(); ++k)
      if (static_cast<std::string>(payload[0][k][0]) == "/rosout")
        return static_cast<int>(subscriber_.getNumPublishers()) >= payload[0][k][1].size();
    return false;
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
