#pragma once

#include <chrono>
#include <optional>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>

namespace ratchet_sieve
{

/// Publishes simulated time on /clock, at a rate of wall time, also while the run is paused, and before every
/// message with a later stamp, so that a subscriber knows the time of a message when it receives it.
class ClockPublisher
{
public:
  /// @param rate [1/s of wall time] @param enabled false: nothing is published, and neither is it where
  /// another node publishes /clock already
  ClockPublisher(ros::NodeHandle node, double rate, bool enabled);

  /// Whether this node is the clock.
  bool enabled() const { return enabled_; }

  /// The node that already publishes /clock, where this one would otherwise.
  const std::optional<std::string>& other() const { return other_; }

  /// A log line about it. @pre other()
  std::string otherText() const;

  /// Publishes if the period is over. @param time simulated [s]
  void publishDue(double time);

  /// Publishes at once.
  void publish(double time);

  /// To be called before a message with this stamp is published. Publishes at most a thousand times per
  /// second of wall time, so that the clock may lag a stamp by 1 ms of wall time.
  void reach(double time);

  /// To be called when a transform has been published. A tf2 listener that receives it after a jump back in
  /// time keeps it as one of the future, and rejects those of the new run as too old: so a jump back waits
  /// until it has arrived.
  void transformSent() { transform_sent_ = std::chrono::steady_clock::now(); }

  /// Blocks until subscribers have received the last jump back in time, if that has just happened. A tf2
  /// listener clears its buffer at the jump, and would clear a transform that it received before with it.
  void waitForTimeJump() const;

private:
  std::chrono::duration<double> period_;
  bool enabled_;
  ros::Publisher publisher_;
  std::optional<std::string> other_;
  std::chrono::steady_clock::time_point last_;
  std::optional<ros::Time> shown_;
  std::chrono::steady_clock::time_point jumped_back_;     ///< when /clock last did
  std::chrono::steady_clock::time_point transform_sent_;  ///< the last
};

}  // namespace ratchet_sieve
