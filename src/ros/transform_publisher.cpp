#include "ratchet_sieve/ros/transform_publisher.h"

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

TransformPublisher::TransformPublisher(ros::NodeHandle node, const std::function<const LiveRun&()>& current,
                                       ClockPublisher& clock)
    : clock_(clock),
      publisher_(node.advertise<tf2_msgs::TFMessage>(
          "/tf", QUEUE_SIZE,
          [this, current](const ros::SingleSubscriberPublisher& subscriber)
          { greet(subscriber, current().base()); }))
{
}

void TransformPublisher::greet(const ros::SingleSubscriberPublisher& subscriber, const BaseFrame& present)
{
  // To all, unless the others have them: a listener warns of those that come twice.
  if (stampOf(present.time) == last_)
    subscriber.publish(baseTransforms(present));
  else
    publish(present);
}

void TransformPublisher::publish(const BaseFrame& frame)
{
  if (stampOf(frame.time) == last_)
    return;
  last_ = stampOf(frame.time);
  if (publisher_.getNumSubscribers() == 0)
    return;
  clock_.reach(frame.time);
  publisher_.publish(baseTransforms(frame));
}

}  // namespace ratchet_sieve
