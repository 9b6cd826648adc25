#include "ratchet_sieve/ros/transform_publisher.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
constexpr std::uint32_t QUEUE_SIZE = 100;
}  // namespace

tf2_msgs::TFMessage baseTransforms(const BaseFrame& frame, const FrameNames& names)
{
  const double inclination = frame.base.inclination;
  geometry_msgs::TransformStamped mount;
  mount.header.stamp = stampOf(frame.time);
  mount.header.frame_id = names.world;
  mount.child_frame_id = names.mount;
  // y of the world points away from the viewer: a turn that raises the right end is negative about it.
  mount.transform.rotation.w = std::cos(0.5 * inclination);
  mount.transform.rotation.y = -std::sin(0.5 * inclination);

  geometry_msgs::TransformStamped base;
  base.header.stamp = mount.header.stamp;
  base.header.frame_id = names.mount;
  base.child_frame_id = names.base;
  base.transform.rotation.w = 1.0;
  const Eigen::Vector2d shift = Eigen::Rotation2Dd(-inclination) *
                                Eigen::Vector2d(frame.base.horizontal_displacement, frame.base.displacement);
  base.transform.translation.x = shift.x();
  base.transform.translation.z = shift.y();

  tf2_msgs::TFMessage message;
  message.transforms = {mount, base};
  return message;
}

tf2_msgs::TFMessage ownWorldTransform(const std::array<double, 3>& origin, const FrameNames& names)
{
  geometry_msgs::TransformStamped own;
  own.header.frame_id = WORLD_FRAME_ID;
  own.child_frame_id = names.world;
  own.transform.rotation.w = 1.0;
  own.transform.translation.x = origin[0];
  own.transform.translation.y = origin[1];
  own.transform.translation.z = origin[2];
  tf2_msgs::TFMessage message;
  message.transforms = {own};
  return message;
}

ros::Publisher publishOwnWorld(ros::NodeHandle& node, const std::array<double, 3>& origin,
                               const FrameNames& names)
{
  ros::Publisher publisher = node.advertise<tf2_msgs::TFMessage>("/tf_static", 1, true);
  publisher.publish(ownWorldTransform(origin, names));
  return publisher;
}

TransformPublisher::TransformPublisher(ros::NodeHandle node, ClockPublisher* clock, const FrameNames& names)
    : clock_(clock),
      names_(names),
      publisher_(node.advertise<tf2_msgs::TFMessage>(
          "/tf", QUEUE_SIZE, [this](const ros::SingleSubscriberPublisher& subscriber) { greet(subscriber); },
          [this](const ros::SingleSubscriberPublisher&)
          {
            --greeted_;
            reached_ = std::max(reached_ - 1, 0);
          }))
{
}

void TransformPublisher::greet(const ros::SingleSubscriberPublisher& subscriber)
{
  ++greeted_;
  if (last_ && greeted_ > reached_)
    subscriber.publish(baseTransforms(*last_, names_));
}

void TransformPublisher::publish(const BaseFrame& frame)
{
  const bool repeated = last_ && stampOf(last_->time) == stampOf(frame.time);
  last_ = frame;
  if (repeated)
    return;
  reached_ = static_cast<int>(publisher_.getNumSubscribers());
  if (reached_ == 0)
    return;
  if (clock_ != nullptr)
  {
    clock_->reach(frame.time);
    clock_->letLeapBeHeard();
  }
  publisher_.publish(baseTransforms(frame, names_));
}

}  // namespace ratchet_sieve
