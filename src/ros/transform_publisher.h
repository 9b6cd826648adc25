#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/TransformStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/single_subscriber_publisher.h>
#include <tf2_ros/transform_broadcaster.h>
#include <Eigen/Geometry>

#include "clock_publisher.h"
#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{

/// Queue length of publishers and subscribers. The same as in tf2_ros::TransformBroadcaster: all publishers
/// of a node for one topic share a queue, with the length requested by the first.
constexpr std::uint32_t QUEUE_SIZE = 100;

/// The names of the frames of one sieve.
struct FrameNames
{
  /// Of every message; origin at the base's foot. A sieve that is mounted elsewhere in `world` has its own.
  std::string world = WORLD_FRAME_ID;

  /// The mount of the base: origin at the base's foot at s = 0 in its mean position, axes turned by the
  /// inclination. It does not follow the drive.
  std::string mount = "sieve_mount";

  /// The base itself: x along it (s), z normal to it (n).
  std::string base = "sieve_base";
};

/// The default of ~frame_prefix: the sieve's name; empty for /sieve.
/// @param sieve name of its node, resolved
std::string defaultFramePrefix(const std::string& sieve);

/// Why `prefix` cannot be the prefix of a frame_id; empty if it can. The empty prefix is allowed.
std::string framePrefixError(const std::string& prefix);

/// @param own_world whether the sieve is mounted elsewhere than in the origin of `world`
FrameNames frameNames(const std::string& prefix, bool own_world);

/// The rotation by the inclination, in the space of ROS: x to the right, z up, y away from the viewer.
Eigen::Quaterniond inclinationInSpace(const DriveState& base);

/// The drive's displacement, in the world frame [m].
Eigen::Vector3d displacementInSpace(const DriveState& base);

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
  explicit TransformPublisher(ros::NodeHandle node, ClockPublisher* clock = nullptr);
  TransformPublisher(const TransformPublisher&) = delete;
  TransformPublisher& operator=(const TransformPublisher&) = delete;

  void publish(const BaseFrame& frame, const FrameNames& names);

private:
  void subscriberConnected(const ros::SingleSubscriberPublisher& subscriber);
  void subscriberDisconnected();

  ClockPublisher* clock_;
  std::vector<geometry_msgs::TransformStamped> last_;
  int reached_ = 0;    ///< subscribers at the last broadcast, including connections not yet reported
  int connected_ = 0;  ///< subscribers whose connection was reported
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::Publisher subscriptions_;  ///< of /tf as well: the broadcaster does not report its subscribers
};

}  // namespace ratchet_sieve
