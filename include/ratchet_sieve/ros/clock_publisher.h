#pragma once

#include <chrono>
#include <optional>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/time.h>

namespace ratchet_sieve
{

/// Publishes simulated time on /clock, at a rate of wall time, also while it stands still, and before every
/// message that is stamped later than it: who gets a message knows its time already.
class ClockPublisher
{
public:
  /// @param rate [1/s of wall time] @param enabled false: nothing is published, and neither is it where
  /// another node publishes /clock already
  ClockPublisher(ros::NodeHandle node, double rate, bool enabled);

  /// Whether this node is the clock.
  bool enabled() const { return enabled_; }

  /// The node that is the clock in place of this one, which would be.
  const std::optional<std::string>& other() const { return other_; }

  /// What that means, in a sentence. @pre other()
  std::string otherText() const;

  /// Publishes, if it is time to. @param time simulated [s]
  void publishDue(double time);

  /// Publishes at once, so that who asks for the time now gets this.
  void publish(double time);

  /// To be called before a message with this stamp is published. Publishes, but no more than a thousand times
  /// a second of wall time: so much the clock may be behind a stamp.
  void reach(double time);

  /// Where time has leapt back just now: waits for a moment, in which others hear of it. A transform that
  /// came to a tf2 listener before would be taken for an old one, and thrown away with those.
  void letLeapBeHeard() const;

private:
  std::chrono::duration<double> period_;
  bool enabled_;
  ros::Publisher publisher_;
  std::optional<std::string> other_;
  std::chrono::steady_clock::time_point last_;
  std::optional<ros::Time> shown_;
  std::chrono::steady_clock::time_point leapt_;  ///< back, last
};

}  // namespace ratchet_sieve
