#pragma once

#include <optional>
#include <string>

#include <ros/node_handle.h>
#include <boost/shared_ptr.hpp>

#include "ratchet_sieve/BaseState.h"
#include "ratchet_sieve/BinCounts.h"
#include "ratchet_sieve/SceneDescription.h"
#include "ratchet_sieve/SeekTrial.h"
#include "ratchet_sieve/SieveStatistics.h"
#include "ratchet_sieve/ros/seek_parameters.h"
#include "ratchet_sieve/seeking/seek_control.h"

namespace ratchet_sieve
{

/// A trial as a message for ~trials.
SeekTrial toMessage(const SeekReport& report);

/// A trial as a log line.
std::string trialText(const SeekReport& report);

/// Searches for the inclination at which a sieve separates best: subscribes to ~base, ~bins, ~statistics and
/// ~scene of the sieve, commands its ~inclination_setpoint, and publishes each trial on ~trials (latched).
/// SeekControl makes the decisions; this class connects it to ROS.
class SeekNode
{
public:
  /// @throws ParameterError
  explicit SeekNode(ros::NodeHandle private_node);

private:
  template <typename Message>
  void hear(const ros::MessageEvent<const Message>& event, boost::shared_ptr<ros::M_string>& connection);
  void takeScene(const SceneDescription& scene);
  void publish(const SeekReport& report);
  void command();
  void watch();
  void warnOfSilence();

  SeekParameters parameters_;
  SeekControl control_;
  boost::shared_ptr<ros::M_string> base_connection_;  ///< the connection of the last message on ~base
  boost::shared_ptr<ros::M_string> bins_connection_;
  std::optional<std::string> scene_hash_;  ///< hash of the keys that no setpoint changes
  std::optional<double> sent_;             ///< the last setpoint [rad]
  ros::SteadyTime sent_at_;
  ros::SteadyTime heard_at_;
  bool silent_ = false;
  unsigned restarts_ = 0;
  unsigned interruptions_ = 0;
  ros::Publisher setpoint_;
  ros::Publisher trials_;
  ros::Subscriber base_;
  ros::Subscriber bins_;
  ros::Subscriber statistics_;
  ros::Subscriber scene_;
  ros::SteadyTimer timer_;
};

}  // namespace ratchet_sieve
