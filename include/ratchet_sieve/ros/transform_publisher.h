#pragma once

#include <optional>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>
#include <tf2_msgs/TFMessage.h>

#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/ros/clock_publisher.h"

namespace ratchet_sieve
{

/// The base's foot at s = 0, at rest, turned with the base: the frame in which the drive is a
/// vertical displacement of the world.
constexpr const char* MOUNT_FRAME_ID = "sieve_mount";

/// The base itself: x along it (s), z normal to it (n).
constexpr const char* BASE_FRAME_ID = "sieve_base";

/// The transforms world -> sieve_mount -> sieve_base at one instant.
tf2_msgs::TFMessage baseTransforms(const BaseFrame& frame);

/// Publishes them on /tf, none twice with one stamp, which tf2 ignores and warns of; converts nothing where
/// nobody listens. A subscriber that comes while the run stands still gets the last ones.
class TransformPublisher
{
public:
  /// @param clock is brought to the stamp of what is published; outlives this. Nothing: another node is the
  /// clock
  explicit TransformPublisher(ros::NodeHandle node, ClockPublisher* clock = nullptr);
  TransformPublisher(const TransformPublisher&) = delete;
  TransformPublisher& operator=(const TransformPublisher&) = delete;

  void publish(const BaseFrame& frame);

private:
  void greet(const ros::SingleSubscriberPublisher& subscriber);

  ClockPublisher* clock_;
  std::optional<BaseFrame> last_;
  int reached_ = 0;  ///< subscribers that got those of the last stamp, greeted yet or not
  int greeted_ = 0;  ///< subscribers that are there, as far as their greeting has come up
  ros::Publisher publisher_;
};

}  // namespace ratchet_sieve
