#include "ratchet_sieve/ros/schedule_node.h"

#include <algorithm>

#include <ros/console.h>
#include <ros/single_subscriber_publisher.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>

#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/ros/scene_parameters.h"

namespace ratchet_sieve
{
namespace
{
constexpr std::uint32_t QUEUE_SIZE = 100;

std::vector<ScheduleEntry> readSchedule(const ros::NodeHandle& node)
{
  const std::string source = "parameter " + node.resolveName("schedule");
  XmlRpc::XmlRpcValue value;
  if (!node.getParam("schedule", value))
    throw ParameterError(source + ": not set");
  return scheduleFromYaml(yamlFromParameter(value, source), source);
}
}  // namespace

ScheduleNode::ScheduleNode(ros::NodeHandle private_node)
    : sieve_(private_node.resolveName(private_node.param<std::string>("sieve", "/sieve"))),
      schedule_(readSchedule(private_node))
{
  unpause_ = private_node.serviceClient<std_srvs::Empty>(sieve_ + "/unpause_physics");
  for (const char* name : SCHEDULED)
    setpoints_.push_back(private_node.advertise<std_msgs::Float64>(
        sieve_ + "/" + name + "_setpoint", QUEUE_SIZE,
        [this](const ros::SingleSubscriberPublisher&) { startOnceConnected(); },
        [this](const ros::SingleSubscriberPublisher& subscriber) { lose(subscriber.getSubscriberName()); }));
  base_ = private_node.subscribe<BaseState>(
      sieve_ + "/base", QUEUE_SIZE, [this](const BaseState::ConstPtr& base) { follow(*base); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
}

void ScheduleNode::lose(const std::string& subscriber)
{
  if (subscriber != sieve_ || !started_)
    return;
  ROS_WARN("%s is gone: waiting for it to come again", sieve_.c_str());
  started_ = false;
  base_seen_ = false;
}

void ScheduleNode::follow(const BaseState& base)
{
  base_seen_ = true;
  if (base.time < last_time_)
    next_ = 0;
  last_time_ = base.time;
  startOnceConnected();
  while (started_ && next_ < schedule_.size() && schedule_[next_].time <= base.time)
    command(schedule_[next_++]);
}

void ScheduleNode::command(const ScheduleEntry& entry)
{
  for (std::size_t k = 0; k < SCHEDULED.size(); ++k)
  {
    if (!entry.values[k])
      continue;
    std_msgs::Float64 message;
    message.data = *entry.values[k];
    setpoints_[k].publish(message);
  }
}

bool ScheduleNode::connected() const
{
  return base_seen_ && std::all_of(setpoints_.begin(), setpoints_.end(),
                                   [](const ros::Publisher& p) { return p.getNumSubscribers() > 0; });
}

void ScheduleNode::startOnceConnected()
{
  if (started_ || !connected())
    return;
  started_ = true;
  std_srvs::Empty nothing;
  if (!unpause_.waitForExistence() || !unpause_.call(nothing))
    ROS_ERROR("%s cannot be called", unpause_.getService().c_str());
}

}  // namespace ratchet_sieve
