#include "ratchet_sieve/ros/transform_publisher.h"

#include <algorithm>
#include <cmath>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
constexpr std::uint32_t QUEUE_SIZE = 100;
}  // namespace

tf2_msgs::TFMessage baseTransforms(const BaseFrame& frame)
{
  const double inclination = frame.base.inclination;
  geometry_msgs::TransformStamped mount;
  mount.header.stamp = stampOf(frame.time);
  mount.header.frame_id = WORLD_FRAME_ID;
  mount.child_frame_id = MOUNT_FRAME_ID;
  // y of the world points away from the viewer: a turn that raises the right end is negative about it.
  mount.transform.rotation.w = std::cos(0.5 * inclination);
  mount.transform.rotation.y = -std::sin(0.5 * inclination);

  geometry_msgs::TransformStamped base;
  base.header.stamp = mount.header.stamp;
  base.header.frame_id = MOUNT_FRAME_ID;
  base.child_frame_id = BASE_FRAME_ID;
  base.transform.rotation.w = 1.0;
  base.transform.translation.x = frame.base.displacement * std::sin(inclination);
  base.transform.translation.z = frame.base.displacement * std::cos(inclination);

  tf2_msgs::TFMessage message;
  message.transforms = {mount, base};
  return message;
}

TransformPublisher::TransformPublisher(ros::NodeHandle node, ClockPublisher* clock)
    : clock_(clock),
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
    subscriber.publish(baseTransforms(*last_));
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
  publisher_.publish(baseTransforms(frame));
}

}  // namespace ratchet_sieve
