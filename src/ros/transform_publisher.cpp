#include "transform_publisher.h"

#include <algorithm>

#include <ros/names.h>
#include <tf2_eigen/tf2_eigen.h>
#include <tf2_msgs/TFMessage.h>

namespace ratchet_sieve
{
namespace
{
constexpr const char* UNPREFIXED_SIEVE = "/sieve";

std::string prefixed(const std::string& prefix, const std::string& frame)
{
  return prefix.empty() ? frame : prefix + "/" + frame;
}

geometry_msgs::TransformStamped transformBetween(const std::string& parent, const std::string& child,
                                                 const Eigen::Quaterniond& rotation,
                                                 const Eigen::Vector3d& translation)
{
  geometry_msgs::TransformStamped message;
  message.header.frame_id = parent;
  message.child_frame_id = child;
  message.transform.rotation = tf2::toMsg(rotation);
  tf2::toMsg(translation, message.transform.translation);
  return message;
}
}  // namespace

std::string defaultFramePrefix(const std::string& sieve)
{
  return sieve == UNPREFIXED_SIEVE ? "" : sieve.substr(std::min(sieve.find_first_not_of('/'), sieve.size()));
}

std::string framePrefixError(const std::string& prefix)
{
  std::string error;
  // tf2 refuses a leading slash.
  const bool good = prefix.empty() || (ros::names::validate(prefix, error) && prefix.front() != '/' &&
                                       prefix.front() != '~' && prefix.back() != '/');
  return good ? "" : "must be letters, digits, _ and / between them, beginning with a letter, such as s1";
}

FrameNames frameNames(const std::string& prefix, bool own_world)
{
  return {own_world ? prefixed(prefix, "sieve_world") : WORLD_FRAME_ID, prefixed(prefix, FrameNames().mount),
          prefixed(prefix, FrameNames().base)};
}

/// It is positive if the right end is raised, which is a negative rotation about y.
Eigen::Quaterniond inclinationInSpace(const DriveState& base)
{
  return Eigen::Quaterniond(Eigen::AngleAxisd(-base.inclination, Eigen::Vector3d::UnitY()));
}

Eigen::Vector3d displacementInSpace(const DriveState& base)
{
  return {base.horizontal_displacement, 0.0, base.displacement};
}

std::vector<geometry_msgs::TransformStamped> baseTransforms(const BaseFrame& frame, const FrameNames& names)
{
  const Eigen::Quaterniond rotation = inclinationInSpace(frame.base);
  std::vector<geometry_msgs::TransformStamped> transforms = {
      transformBetween(names.world, names.mount, rotation, Eigen::Vector3d::Zero()),
      transformBetween(names.mount, names.base, Eigen::Quaterniond::Identity(),
                       rotation.conjugate() * displacementInSpace(frame.base))};
  for (geometry_msgs::TransformStamped& message : transforms)
    message.header.stamp = ros::Time(frame.time);
  return transforms;
}

geometry_msgs::TransformStamped ownWorldTransform(const std::array<double, 3>& origin,
                                                  const FrameNames& names)
{
  return transformBetween(WORLD_FRAME_ID, names.world, Eigen::Quaterniond::Identity(),
                          Eigen::Vector3d(origin.data()));
}

TransformPublisher::TransformPublisher(ros::NodeHandle node, ClockPublisher* clock)
    : clock_(clock),
      subscriptions_(node.advertise<tf2_msgs::TFMessage>(
          "/tf", QUEUE_SIZE,
          [this](const ros::SingleSubscriberPublisher& subscriber) { subscriberConnected(subscriber); },
          [this](const ros::SingleSubscriberPublisher&) { subscriberDisconnected(); }))
{
}

void TransformPublisher::subscriberConnected(const ros::SingleSubscriberPublisher& subscriber)
{
  ++connected_;
  if (last_.empty() || connected_ <= reached_)
    return;
  tf2_msgs::TFMessage message;
  message.transforms = last_;
  subscriber.publish(message);
}

void TransformPublisher::subscriberDisconnected()
{
  --connected_;
  reached_ = std::max(reached_ - 1, 0);
}

void TransformPublisher::publish(const BaseFrame& frame, const FrameNames& names)
{
  const bool repeated = !last_.empty() && last_.front().header.stamp == ros::Time(frame.time);
  last_ = baseTransforms(frame, names);
  if (repeated)
    return;
  reached_ = static_cast<int>(subscriptions_.getNumSubscribers());
  if (reached_ == 0)
    return;
  if (clock_ != nullptr)
  {
    clock_->reach(frame.time);
    clock_->waitForTimeJump();
  }
  broadcaster_.sendTransform(last_);
  if (clock_ != nullptr)
    clock_->transformSent();
}

}  // namespace ratchet_sieve
