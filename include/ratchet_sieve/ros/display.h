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

/// Shows pictures of a run on ~markers and ~cloud, at a rate of wall time: what eyes can follow, however
/// fast the run goes. Knows nothing of where the pictures come from.
class Display
{
public:
  /// @param rate at most [1/s of wall time]; 0: nothing is shown
  Display(ros::NodeHandle private_node, double rate);

  /// Whether anybody subscribes to ~markers or ~cloud.
  bool watched() const { return markers_.getNumSubscribers() > 0 || cloud_.getNumSubscribers() > 0; }

  /// Whether a picture of this time would be shown now; false where nobody watches, so that none need be
  /// made. A run that stands still is shown once a second, for those who come. @param time simulated [s]
  bool due(double time) const;

  /// Shows it, and takes away what was drawn before and is no part of it. Converts nothing for a topic
  /// that nobody subscribes to.
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
