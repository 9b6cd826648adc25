#pragma once

#include <chrono>

#include <ros/node_handle.h>
#include <ros/publisher.h>

namespace ratchet_sieve
{

/// Publishes simulated time on /clock, at a rate of wall time, also while it stands still.
class ClockPublisher
{
public:
  /// @param rate [1/s of wall time] @param enabled false: another node is the clock
  ClockPublisher(ros::NodeHandle node, double rate, bool enabled);

  /// Publishes, if it is time to. @param time simulated [s]
  void publishDue(double time);

  /// Publishes at once, so that who asks for the time now gets this.
  void publish(double time);

private:
  std::chrono::duration<double> period_;
  bool enabled_;
  ros::Publisher publisher_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace ratchet_sieve
