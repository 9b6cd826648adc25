#pragma once

#include <chrono>
#include <set>
#include <string>
#include <utility>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "ratchet_sieve/live/picture.h"

namespace ratchet_sieve
{

/// Publishes pictures of a run on ~markers and ~cloud, at a rate of wall time, whatever the speed of the run.
class Display
{
public:
  /// @param rate at most [1/s of wall time]; 0: nothing is shown
  Display(ros::NodeHandle private_node, double rate);

  /// Whether anybody subscribes to ~markers or ~cloud.
  bool watched() const { return markers_.getNumSubscribers() > 0 || cloud_.getNumSubscribers() > 0; }

  /// Whether a picture of this time is to be shown now; false without subscribers, so that none need be made.
  /// A paused run is shown once a second, for new subscribers. @param time simulated [s]
  bool due(double time) const;

  /// Publishes it, and deletes markers drawn before that are no part of it. Converts nothing for a topic
  /// without subscribers.
  /// @param frame_id in which the picture is
  void show(const Picture& picture, const std::string& frame_id);

private:
  using Clock = std::chrono::steady_clock;
  using Names = std::set<std::pair<std::string, int>>;

  void showMarkers(const Picture& picture, const std::string& frame_id);

  double rate_;
  ros::Publisher markers_;
  ros::Publisher cloud_;
  Clock::time_point last_shown_;
  double last_time_ = -1.0;  ///< simulated [s]
  Names last_names_;         ///< namespace and id of every marker that is drawn
};

}  // namespace ratchet_sieve
