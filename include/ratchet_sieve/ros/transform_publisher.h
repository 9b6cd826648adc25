#pragma once

#include <array>
#include <optional>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>
#include <tf2_ros/transform_broadcaster.h>

#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/ros/clock_publisher.h"
#include "ratchet_sieve/ros/frame_names.h"

namespace ratchet_sieve
{

/// The transforms world -> sieve_mount -> sieve_base at one instant.
std::vector<geometry_msgs::TransformStamped> baseTransforms(const BaseFrame& frame,
                                                            const FrameNames& names = FrameNames());

/// The static transform from the shared world frame to the sieve's own.
/// @param origin of the sieve's frame in the shared one: x, y, z [m]
geometry_msgs::TransformStamped ownWorldTransform(const std::array<double, 3>& origin,
                                                  const FrameNames& names);

/// Broadcasts the base's transforms on /tf while there are subscribers, each stamp once: tf2 ignores repeated
/// stamps with a warning. A new subscriber gets the last transforms at once, also in a pause.
class TransformPublisher
{
public:
  /// @param clock is advanced to the stamp of each transform; outlives this. Null: another node publishes
  /// /clock
  explicit TransformPublisher(ros::NodeHandle node, ClockPublisher* clock = nullptr,
                              const FrameNames& names = FrameNames());
  TransformPublisher(const TransformPublisher&) = delete;
  TransformPublisher& operator=(const TransformPublisher&) = delete;

  void publish(const BaseFrame& frame);

  /// Sets the frame names for later transforms.
  void setNames(const FrameNames& names) { names_ = names; }

private:
  void subscriberConnected(const ros::SingleSubscriberPublisher& subscriber);
  void subscriberDisconnected();

  ClockPublisher* clock_;
  FrameNames names_;
  std::optional<BaseFrame> last_;
  int reached_ = 0;    ///< subscribers at the last broadcast, including connections not yet reported
  int connected_ = 0;  ///< subscribers whose connection was reported
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Publisher
      subscriptions_;  ///< the same topic, to observe its subscribers, which the broadcaster does not report
};

}  // namespace ratchet_sieve
