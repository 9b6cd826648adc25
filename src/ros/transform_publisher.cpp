#include "ratchet_sieve/ros/transform_publisher.h"

#include <algorithm>

#include <tf2_eigen/tf2_eigen.h>
#include <tf2_msgs/TFMessage.h>

#include "plane_in_space.h"
#include "queue_size.h"
#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
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

std::vector<geometry_msgs::TransformStamped> baseTransforms(const BaseFrame& frame, const FrameNames& names)
{
  const Eigen::Quaterniond rotation = inclinationInSpace(frame.base);
  std::vector<geometry_msgs::TransformStamped> transforms = {
      transformBetween(names.world, names.mount, rotation, Eigen::Vector3d::Zero()),
      transformBetween(names.mount, names.base, Eigen::Quaterniond::Identity(),
                       rotation.conjugate() * displacementInSpace(frame.base))};
  for (geometry_msgs::TransformStamped& message : transforms)
    message.header.stamp = stampOf(frame.time);
  return transforms;
}

geometry_msgs::TransformStamped ownWorldTransform(const std::array<double, 3>& origin,
                                                  const FrameNames& names)
{
  return transformBetween(WORLD_FRAME_ID, names.world, Eigen::Quaterniond::Identity(),
                          Eigen::Vector3d(origin.data()));
}

TransformPublisher::TransformPublisher(ros::NodeHandle node, ClockPublisher* clock, const FrameNames& names)
    : clock_(clock),
      names_(names),
      subscriptions_(node.advertise<tf2_msgs::TFMessage>(
          "/tf", QUEUE_SIZE,
          [this](const ros::SingleSubscriberPublisher& subscriber) { subscriberConnected(subscriber); },
          [this](const ros::SingleSubscriberPublisher&) { subscriberDisconnected(); }))
{
}

void TransformPublisher::subscriberConnected(const ros::SingleSubscriberPublisher& subscriber)
{
  ++connected_;
  if (!last_ || connected_ <= reached_)
    return;
  tf2_msgs::TFMessage message;
  message.transforms = baseTransforms(*last_, names_);
  subscriber.publish(message);
}

void TransformPublisher::subscriberDisconnected()
{
  --connected_;
  reached_ = std::max(reached_ - 1, 0);
}

void TransformPublisher::publish(const BaseFrame& frame)
{
  const bool repeated = last_ && stampOf(last_->time) == stampOf(frame.time);
  last_ = frame;
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
  broadcaster_.sendTransform(baseTransforms(frame, names_));
  if (clock_ != nullptr)
    clock_->transformSent();
}

}  // namespace ratchet_sieve
