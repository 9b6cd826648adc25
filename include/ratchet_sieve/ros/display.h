#pragma once

#include <chrono>

#include <ros/node_handle.h>
#include <ros/publisher.h>

#include "ratchet_sieve/ros/live_run.h"
#include "ratchet_sieve/ros/transform_publisher.h"

namespace ratchet_sieve
{

/// Shows the run on ~markers and ~cloud, at a rate of wall time: what eyes can follow, however fast
/// the run goes. Converts nothing for a topic that nobody subscribes to.
class Display
{
public:
  /// @param rate at most [1/s of wall time]; 0: nothing is shown
  Display(ros::NodeHandle private_node, double rate, TransformPublisher& transforms);

  /// Shows the run as it stands, if it is time to. A run that stands still is shown once a second,
  /// for those who come.
  void show(const LiveRun& run);

private:
  using Clock = std::chrono::steady_clock;

  bool due(double time) const;
  void showMarkers(const LiveRun& run);

  double rate_;
  TransformPublisher& transforms_;
  ros::Publisher markers_;
  ros::Publisher cloud_;
  Clock::time_point last_shown_;
  double last_time_ = -1.0;  ///< simulated [s]
  double last_start_ = 0.0;
};

}  // namespace ratchet_sieve
