#include "ratchet_sieve/ros/topic_publisher.h"

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
/// Half a second of frames at the default rates: a subscriber that is slower than that loses some. Each has a
/// queue of its own, so that one that takes nothing costs the others nothing.
constexpr std::uint32_t QUEUE_SIZE = 30;

template <typename Frame>
ros::Publisher advertise(ros::NodeHandle& node, const std::string& topic,
                         const std::function<const LiveRun&()>& current, const std::string& frame_id,
                         Frame (LiveRun::*state)() const)
{
  using Message = decltype(toMessage(std::declval<Frame>()));
  return node.advertise<Message>(topic, QUEUE_SIZE,
                                 [current, frame_id, state](const ros::SingleSubscriberPublisher& subscriber)
                                 { subscriber.publish(inFrame(frame_id, toMessage((current().*state)()))); });
}
}  // namespace

template <typename Frame>
void TopicPublisher::publish(const ros::Publisher& publisher, const Frame& frame)
{
  if (publisher.getNumSubscribers() == 0)
    return;
  clock_.reach(frame.time);
  publisher.publish(inFrame(frame_id_, toMessage(frame)));
}

TopicPublisher::TopicPublisher(ros::NodeHandle private_node, const std::function<const LiveRun&()>& current,
                               const std::string& frame_id, ClockPublisher& clock,
                               TransformPublisher& transforms)
    : current_(current),
      frame_id_(frame_id),
      clock_(clock),
      transforms_(transforms),
      scene_(private_node.advertise<SceneDescription>("scene", 1, true)),
      particles_(advertise(private_node, "particles", current, frame_id, &LiveRun::particles)),
      bins_(advertise(private_node, "bins", current, frame_id, &LiveRun::bins)),
      base_(advertise(private_node, "base", current, frame_id, &LiveRun::base)),
      statistics_(advertise(private_node, "statistics", current, frame_id, &LiveRun::statistics)),
      commands_(private_node.advertise<Command>("commands", QUEUE_SIZE))
{
}

bool TopicPublisher::wants(FrameKind kind) const
{
  switch (kind)
  {
    case FrameKind::PARTICLES:
      return particles_.getNumSubscribers() > 0;
    case FrameKind::BINS:
      return bins_.getNumSubscribers() > 0;
    case FrameKind::BASE:
      return true;  // a few numbers: the transforms have to know what they last showed
    case FrameKind::STATISTICS:
      return statistics_.getNumSubscribers() > 0;
  }
  return true;
}

void TopicPublisher::take(const SceneFrame& frame)
{
  clock_.reach(frame.time);
  scene_.publish(inFrame(frame_id_, toMessage(frame)));
}

void TopicPublisher::take(const ParticleFrame& frame)
{
  if (particles_.getNumSubscribers() > 0)
    transforms_.publish(current_().base());
  publish(particles_, frame);
}

void TopicPublisher::take(const BinFrame& frame)
{
  publish(bins_, frame);
}

void TopicPublisher::take(const BaseFrame& frame)
{
  publish(base_, frame);
  transforms_.publish(frame);
}

void TopicPublisher::take(const StatisticsFrame& frame)
{
  publish(statistics_, frame);
}

void TopicPublisher::take(const CommandFrame& frame)
{
  publish(commands_, frame);
}

}  // namespace ratchet_sieve
