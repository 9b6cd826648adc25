#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>

namespace ratchet_sieve
{

/// Whether a node, asked itself, says that it publishes a topic. Waits up to 2 s for its answer.
/// @param node, topic resolved
bool publishes(const std::string& node, const std::string& topic);

/// Publishes simulated time on /clock at a rate of wall time, also in a pause, and before every message with
/// a later stamp. So a subscriber knows the time of a message when it receives it.
class ClockPublisher
{
public:
  /// @param rate [1/s of wall time] @param enabled false: nothing is published. Nothing is published either
  /// if another node already publishes /clock.
  ClockPublisher(ros::NodeHandle node, double rate, bool enabled);

  /// Whether this node publishes /clock.
  bool enabled() const { return enabled_; }

  /// A log line that names the node that already publishes /clock, if this node was to publish it; otherwise
  /// empty.
  const std::string& conflict() const { return conflict_; }

  /// Publishes if one period has passed. @param time simulated [s]
  void publishDue(double time);

  /// Publishes at once.
  void publish(double time);

  /// To be called before a message with this stamp is published. Publishes at most a thousand times per
  /// second of wall time, so the clock may lag behind a stamp by 1 ms of wall time.
  void reach(double time);

  /// To be called after a transform was published. A jump back in time is delayed until subscribers have
  /// received the transform. Otherwise a tf2 listener that receives it after the jump keeps it as a transform
  /// of the future, and rejects those of the new run as too old.
  void transformSent() { transform_sent_ = std::chrono::steady_clock::now(); }

  /// Blocks until subscribers have received a jump back in time that was just published. A tf2 listener
  /// clears its buffer at the jump, and would discard a transform received before.
  void waitForTimeJump() const;

private:
  std::chrono::duration<double> period_;
  bool enabled_;
  ros::Publisher publisher_;
  std::string conflict_;
  std::chrono::steady_clock::time_point last_;
  std::optional<ros::Time> shown_;
  std::chrono::steady_clock::time_point jumped_back_;     ///< time of the last jump back of /clock
  std::chrono::steady_clock::time_point transform_sent_;  ///< the last
};

}  // namespace ratchet_sieve
