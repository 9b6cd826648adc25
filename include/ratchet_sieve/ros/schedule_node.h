#pragma once

#include <string>
#include <vector>

#include <ros/node_handle.h>

#include "ratchet_sieve/BaseState.h"
#include "ratchet_sieve/ros/schedule.h"

namespace ratchet_sieve
{

/// Commands a sieve over its setpoint topics when its simulated time, as ~base of the sieve has it,
/// comes to the entries of a schedule. Sets a paused sieve going once it is connected, so that no
/// command is late. Where the sieve is begun anew, so is the schedule; where its node has died and comes
/// again, that one is set going as the first was.
class ScheduleNode
{
public:
  /// Reads ~sieve (the name of the sieve's node, /sieve by default) and ~schedule.
  /// @throws ParameterError
  explicit ScheduleNode(ros::NodeHandle private_node);

private:
  void follow(const BaseState& base);
  void command(const ScheduleEntry& entry);
  bool connected() const;
  void lose(const std::string& subscriber);
  void startOnceConnected();

  std::string sieve_;  ///< name of its node
  std::vector<ScheduleEntry> schedule_;
  std::size_t next_ = 0;
  double last_time_ = 0.0;  ///< of the sieve [s]
  bool base_seen_ = false;
  bool started_ = false;
  ros::ServiceClient unpause_;
  std::vector<ros::Publisher> setpoints_;  ///< per SCHEDULED
  ros::Subscriber base_;
};

}  // namespace ratchet_sieve
