#include "sensor_publisher.h"

#include <utility>

#include <geometry_msgs/WrenchStamped.h>

#include "ratchet_sieve/DeckLevel.h"
#include "ratchet_sieve/DiskCounts.h"

namespace ratchet_sieve
{
namespace
{
constexpr std::uint32_t READING_QUEUE_SIZE = 100;

ros::Publisher advertiseSensor(ros::NodeHandle& node, const SensorInfo& sensor)
{
  switch (sensor.kind)
  {
    case SensorKind::SCALE:
      return node.advertise<geometry_msgs::WrenchStamped>(sensor.name, READING_QUEUE_SIZE);
    case SensorKind::COUNT:
      return node.advertise<DiskCounts>(sensor.name, READING_QUEUE_SIZE);
    default:
      return node.advertise<DeckLevel>(sensor.name, READING_QUEUE_SIZE);
  }
}
}  // namespace

SensorPublisher::SensorPublisher(ros::NodeHandle private_node, const SensorParameters& sensors,
                                 const std::function<const Run&()>& current, std::string frame_id,
                                 ClockPublisher& clock)
    : current_(current), frame_id_(std::move(frame_id)), clock_(clock)
{
  for (const SensorInfo& sensor : SENSOR_LIST)
    if (sensors[static_cast<std::size_t>(sensor.kind)])
      publishers_[sensor.name] = advertiseSensor(private_node, sensor);
}

void SensorPublisher::publish(const Sensor& sensor, const Reading& reading)
{
  const ros::Publisher& publisher = publishers_.at(sensor.info().name);
  if (publisher.getNumSubscribers() == 0)
    return;
  const Simulation& simulation = current_().simulation();
  clock_.reach(simulation.time());
  const auto send = [&](auto message)
  {
    message.header.stamp = ros::Time(reading.time);
    message.header.frame_id = frame_id_;
    publisher.publish(message);
  };
  if (sensor.info().kind == SensorKind::SCALE)
  {
    geometry_msgs::WrenchStamped message;
    message.wrench.force.z = 0.0 - reading.values.front() * simulation.scene().gravity;  // no -0.0
    return send(message);
  }
  if (sensor.info().kind == SensorKind::COUNT)
  {
    DiskCounts message;
    message.time = reading.time;
    message.species = speciesNames(simulation.scene());
    message.count.assign(reading.values.begin(), reading.values.end());
    return send(message);
  }
  DeckLevel message;
  message.time = reading.time;
  message.level = reading.values.front();
  send(message);
}

}  // namespace ratchet_sieve
