#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "ratchet_sieve/BaseState.h"
#include "ratchet_sieve/ros/schedule.h"

namespace ratchet_sieve
{

/// Commands a sieve over its setpoint topics when its simulated time, taken from its ~base, reaches the
/// entries of a schedule. Unpauses a paused sieve once it is connected, so that no command is late. Starts
/// again from the beginning when time jumps back (~reset) or the sieve was restarted.
class ScheduleNode
{
public:
  /// Reads ~sieve (the name of the sieve's node, default `sieve` in this node's namespace), ~schedule and
  /// ~exit_at_end (default false: whether to shut ROS down after the last entry). Warns of setpoints that the
  /// sieve will refuse. @throws ParameterError
  explicit ScheduleNode(ros::NodeHandle private_node);

private:
  void follow(const BaseState& base);
  void command(const ScheduleEntry& entry, double now);
  void end(double now);
  void beginAnew();
  bool connected() const;
  void startOnceConnected();

  ros::NodeHandle node_;
  std::string sieve_;
  bool exit_at_end_ = false;
  std::vector<ScheduleEntry> schedule_;
  std::size_t next_ = 0;
  double last_time_ = 0.0;  ///< simulated, as last received [s]
  bool base_seen_ = false;
  bool started_ = false;
  ros::ServiceClient unpause_;
  std::vector<ros::Publisher> setpoints_;  ///< per SCHEDULED
  ros::Subscriber base_;
  ros::SteadyTimer timer_;
};

}  // namespace ratchet_sieve
