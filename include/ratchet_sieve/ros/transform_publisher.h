#pragma once

#include <functional>
#include <optional>

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>
#include <tf2_msgs/TFMessage.h>

#include "ratchet_sieve/ros/clock_publisher.h"
#include "ratchet_sieve/ros/live_run.h"

namespace ratchet_sieve
{

/// The base's foot at s = 0, at rest, turned with the base: the frame in which the drive is a
/// vertical displacement of the world.
constexpr const char* MOUNT_FRAME_ID = "sieve_mount";

/// The base itself: x along it (s), z normal to it (n).
constexpr const char* BASE_FRAME_ID = "sieve_base";

/// The transforms world -> sieve_mount -> sieve_base at one instant.
tf2_msgs::TFMessage baseTransforms(const BaseFrame& frame);

/// Publishes them on /tf, for one stamp never twice: a tf2 listener would warn of the second, and drop it.
/// Converts nothing where nobody listens. A subscriber that comes while the run stands still gets the present
/// ones.
class TransformPublisher
{
public:
  /// @param current gives the run, also after a reset
  /// @param clock is brought to the stamp of whatever is published; outlives this
  TransformPublisher(ros::NodeHandle node, const std::function<const LiveRun&()>& current,
                     ClockPublisher& clock);

  void publish(const BaseFrame& frame);

  /// Of what is shown beside them, too.
  ClockPublisher& clock() { return clock_; }

private:
  void greet(const ros::SingleSubscriberPublisher& subscriber, const BaseFrame& present);

  ClockPublisher& clock_;
  ros::Publisher publisher_;
  std::optional<ros::Time> last_;  ///< stamp
  int reached_ = 0;                ///< subscribers that got those of this stamp, greeted yet or not
  int greeted_ = 0;                ///< subscribers that are there, as far as their greeting has come up
};

}  // namespace ratchet_sieve
