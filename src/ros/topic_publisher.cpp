#include "topic_publisher.h"

#include <cmath>

#include <geometry_msgs/WrenchStamped.h>
#include <sensor_msgs/JointState.h>

#include "ratchet_sieve/DeckLevel.h"
#include "ratchet_sieve/DiskCounts.h"

namespace ratchet_sieve
{
namespace
{
/// Half a second of frames at the default rates; a subscriber that lags by more loses frames. roscpp has a
/// queue for each subscriber, so that a slow one does not delay the others.
constexpr std::uint32_t FRAME_QUEUE_SIZE = 30;

/// Disks that may leave between two looks of roscpp's thread at the queue: no exit is lost.
constexpr std::uint32_t EXIT_QUEUE_SIZE = 100000;

ros::Publisher advertiseSensor(ros::NodeHandle& node, const SensorInfo& sensor)
{
  switch (sensor.kind)
  {
    case SensorKind::SCALE:
      return node.advertise<geometry_msgs::WrenchStamped>(sensor.name, QUEUE_SIZE);
    case SensorKind::COUNT:
      return node.advertise<DiskCounts>(sensor.name, QUEUE_SIZE);
    default:
      return node.advertise<DeckLevel>(sensor.name, QUEUE_SIZE);
  }
}

/// The base's one joint. @param turning_rate of a base on its way to a setpoint [rad/s]
sensor_msgs::JointState jointState(const BaseFrame& frame, double turning_rate)
{
  const double way = frame.base.commanded_inclination - frame.base.inclination;
  sensor_msgs::JointState message;
  message.header.stamp = ros::Time(frame.time);
  message.name = {describe(Quantity::INCLINATION).name};
  message.position = {frame.base.inclination};
  message.velocity = {way == 0.0 ? 0.0 : std::copysign(turning_rate, way)};
  return message;
}
}  // namespace

/// Advertises the topic of a kind; a new subscriber is sent the present state.
template <typename Frame>
void TopicPublisher::advertise(ros::NodeHandle& node)
{
  const ros::SubscriberStatusCallback give =
      [current = current_, frame_id = frames_.world](const ros::SingleSubscriberPublisher& subscriber)
  {
    if (!hasFrames<Frame>(current().simulation().scene()))
      return;
    Frame frame = current().now<Frame>();
    if constexpr (std::is_same_v<Frame, StatisticsFrame>)
      frame.real_time_factor = current().realTimeFactor();
    subscriber.publish(toMessage(frame, frame_id));
  };
  const FrameKind kind = kindOf<Frame>();
  publishers_[kind] = node.advertise<MessageOf<Frame>>(describe(kind).name, FRAME_QUEUE_SIZE, give);
}

TopicPublisher::TopicPublisher(ros::NodeHandle private_node, const std::function<const Run&()>& current,
                               const NodeParameters& parameters, ClockPublisher& clock,
                               TransformPublisher& transforms)
    : current_(current),
      frames_(parameters.frames),
      clock_(clock),
      transforms_(transforms),
      turning_rate_(parameters.slew_rates.inclination)
{
  publishers_[FrameKind::SCENE] =
      private_node.advertise<SceneDescription>(describe(FrameKind::SCENE).name, 1, true);
  forEachSampledType([&](auto type) { advertise<typename decltype(type)::Frame>(private_node); });
  publishers_[FrameKind::COMMANDS] =
      private_node.advertise<Command>(describe(FrameKind::COMMANDS).name, FRAME_QUEUE_SIZE);
  purity_ = private_node.advertise<Purity>(
      "purity", FRAME_QUEUE_SIZE,
      [current = current_, frame_id = frames_.world](const ros::SingleSubscriberPublisher& subscriber)
      {
        const double window_start = current().now<BinFrame>().window_start;
        subscriber.publish(purityOf(current().simulation(), window_start, frame_id));
      });
  joint_states_ = private_node.advertise<sensor_msgs::JointState>(
      "joint_states", FRAME_QUEUE_SIZE,
      [current = current_, rate = turning_rate_](const ros::SingleSubscriberPublisher& subscriber)
      { subscriber.publish(jointState(current().now<BaseFrame>(), rate)); });
  exits_ = private_node.advertise<DiskExit>("exits", EXIT_QUEUE_SIZE);
  for (const SensorInfo& sensor : SENSOR_LIST)
    if (parameters.sensors.count(sensor.kind) > 0)
      sensors_[sensor.name] = advertiseSensor(private_node, sensor);
}

/// Publishes what make() gives, if there are subscribers. @param time that the clock is to have reached [s]
template <typename Make>
void TopicPublisher::send(const ros::Publisher& publisher, double time, Make&& make)
{
  if (publisher.getNumSubscribers() == 0)
    return;
  clock_.reach(time);
  publisher.publish(make());
}

void TopicPublisher::publish(const ExitRecord& exit)
{
  send(exits_, exit.time,
       [&] {
         return toMessage(exit, current_().simulation().scene().species[exit.species].name, frames_.world);
       });
}

void TopicPublisher::publish(const Sensor& sensor, const Reading& reading)
{
  const Simulation& simulation = current_().simulation();
  const auto send_as = [&](auto message, const auto& fill)
  {
    message.header.stamp = ros::Time(reading.time);
    message.header.frame_id = frames_.world;
    send(sensors_.at(sensor.info().name), simulation.time(),
         [&]
         {
           fill(message);
           return message;
         });
  };
  switch (sensor.info().kind)
  {
    case SensorKind::SCALE:
      return send_as(
          geometry_msgs::WrenchStamped(), [&](auto& message)
          { message.wrench.force.z = 0.0 - reading.values[0] * simulation.scene().gravity; });  // no -0.0
    case SensorKind::COUNT:
      return send_as(DiskCounts(),
                     [&](auto& message)
                     {
                       message.time = reading.time;
                       message.species = speciesNames(simulation.scene());
                       message.count.assign(reading.values.begin(), reading.values.end());
                     });
    default:
      return send_as(DeckLevel(),
                     [&](auto& message)
                     {
                       message.time = reading.time;
                       message.level = reading.values[0];
                     });
  }
}

bool TopicPublisher::wants(FrameKind kind) const
{
  // The transforms need the base also without subscribers, to send the last state to a new one.
  return kind == FrameKind::BASE || isHeard(kind) ||
         (kind == FrameKind::BINS && purity_.getNumSubscribers() > 0);
}

template <typename Frame>
void TopicPublisher::publish(const Frame& frame)
{
  constexpr FrameKind KIND = kindOf<Frame>();
  // The scene is latched, for later subscribers.
  if (KIND != FrameKind::SCENE && !isHeard(KIND))
    return;
  clock_.reach(frame.time);
  publishers_[KIND].publish(toMessage(frame, frames_.world));
}

void TopicPublisher::take(const AnyFrame& any)
{
  if (any.kind() == FrameKind::PARTICLES && isHeard(FrameKind::PARTICLES))
    transforms_.publish(current_().now<BaseFrame>(), frames_);
  any.visit([this](const auto& frame) { publish(frame); });
  if (const BinFrame* bins = any.as<BinFrame>())
    send(purity_, bins->time,
         [&] { return purityOf(current_().simulation(), bins->window_start, frames_.world); });
  if (const BaseFrame* base = any.as<BaseFrame>())
  {
    transforms_.publish(*base, frames_);
    send(joint_states_, base->time, [&] { return jointState(*base, turning_rate_); });
  }
}

}  // namespace ratchet_sieve
