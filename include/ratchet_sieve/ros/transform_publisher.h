#pragma once

#include <array>
#include <optional>

#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>
#include <tf2_msgs/TFMessage.h>

#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/ros/clock_publisher.h"
#include "ratchet_sieve/ros/frame_names.h"

namespace ratchet_sieve
{

/// The transforms world -> sieve_mount -> sieve_base at one instant.
tf2_msgs::TFMessage baseTransforms(const BaseFrame& frame, const FrameNames& names = FrameNames());

/// The transform from the frame that all share to the sieve's own, which stands still.
/// @param origin of the latter in the former: x, y, z [m]
tf2_msgs::TFMessage ownWorldTransform(const std::array<double, 3>& origin, const FrameNames& names);

/// Publishes that on /tf_static, as long as the publisher is kept.
ros::Publisher publishOwnWorld(ros::NodeHandle& node, const std::array<double, 3>& origin,
                               const FrameNames& names);

/// Publishes them on /tf, none twice with one stamp, which tf2 ignores and warns of; converts nothing where
/// nobody listens. A subscriber that comes while the run stands still gets the last ones.
///
/// Not tf2_ros::TransformBroadcaster: it keeps its publisher to itself, so that it can neither be asked who
/// listens nor greet who comes.
class TransformPublisher
{
public:
  /// @param clock is brought to the stamp of what is published; outlives this. Nothing: another node is the
  /// clock
  explicit TransformPublisher(ros::NodeHandle node, ClockPublisher* clock = nullptr,
                              const FrameNames& names = FrameNames());
  TransformPublisher(const TransformPublisher&) = delete;
  TransformPublisher& operator=(const TransformPublisher&) = delete;

  void publish(const BaseFrame& frame);

  /// From now on.
  void setNames(const FrameNames& names) { names_ = names; }

private:
  void greet(const ros::SingleSubscriberPublisher& subscriber);

  ClockPublisher* clock_;
  FrameNames names_;
  std::optional<BaseFrame> last_;
  int reached_ = 0;  ///< subscribers that got those of the last stamp, greeted yet or not
  int greeted_ = 0;  ///< subscribers that are there, as far as their greeting has come up
  ros::Publisher publisher_;
};

}  // namespace ratchet_sieve
