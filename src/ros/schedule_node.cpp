#include "ratchet_sieve/ros/schedule_node.h"

#include <algorithm>

#include <ros/console.h>
#include <ros/init.h>
#include <ros/names.h>
#include <ros/single_subscriber_publisher.h>
#include <std_msgs/Float64.h>
#include <std_srvs/Empty.h>

#include "queue_size.h"
#include "ratchet_sieve/ros/node_parameters.h"
#include "ratchet_sieve/ros/parameter_reader.h"
#include "ratchet_sieve/ros/scene_parameters.h"
#include "ratchet_sieve/ros/sieve_search.h"

namespace ratchet_sieve
{
namespace
{
// Both of wall time [s].
constexpr double WARN_MISSING_AFTER = 10.0;       ///< before the first warning that the sieve is missing
constexpr double LAST_SETPOINT_FLUSH_TIME = 0.5;  ///< for sending the last setpoint before the node exits

std::string sourceOf(const ros::NodeHandle& node)
{
  return "parameter " + node.resolveName("schedule");
}

std::vector<ScheduleEntry> readSchedule(const ros::NodeHandle& node)
{
  XmlRpc::XmlRpcValue value;
  if (!node.getParam("schedule", value))
    throw ParameterError(sourceOf(node) + ": not set");
  return scheduleFromYaml(yamlFromParameter(value, sourceOf(node)), sourceOf(node));
}

/// Only a warning, because a sieve that starts later may have other limits.
void warnOfRefusals(const std::vector<ScheduleEntry>& schedule, const std::string& source,
                    const std::string& sieve)
{
  ParameterReader reader{ros::NodeHandle(sieve)};
  SlewRates slew_rates;
  const auto limited = readSetpoints(reader, slew_rates);
  for (std::size_t k = 0; k < schedule.size(); ++k)
    for (std::size_t q = 0; q < limited.size(); ++q)
      if (const auto refusal = limited[q].refusal(schedule[k].values[q].value_or(limited[q].limits.min)))
        ROS_WARN("%s/%zu: %s, according to the parameters of %s", source.c_str(), k, refusal->c_str(),
                 sieve.c_str());
}
}  // namespace

ScheduleNode::ScheduleNode(ros::NodeHandle private_node)
    : node_(private_node), schedule_(readSchedule(private_node))
{
  ParameterReader reader(private_node);
  sieve_ = ros::names::resolve(reader.text("sieve", DEFAULT_SIEVE));
  exit_at_end_ = reader.flag("exit_at_end", exit_at_end_);
  for (const std::string& name : reader.unknown({"schedule"}))
    ROS_WARN("parameter %s: not known, and ignored", name.c_str());
  warnOfRefusals(schedule_, sourceOf(private_node), sieve_);
  unpause_ = private_node.serviceClient<std_srvs::Empty>(sieve_ + "/unpause_physics");
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    setpoints_.push_back(private_node.advertise<std_msgs::Float64>(
        sieve_ + "/" + setpointTopic(q.quantity), QUEUE_SIZE,
        [this](const ros::SingleSubscriberPublisher&) { startOnceConnected(); },
        [this](const ros::SingleSubscriberPublisher& subscriber)
        {
          // Other subscribers, such as `rosbag record`, do not matter.
          if (started_ && subscriber.getSubscriberName() == sieve_)
            beginAnew();
        }));
  base_ = private_node.subscribe<BaseState>(
      sieve_ + "/base", QUEUE_SIZE, [this](const BaseState::ConstPtr& base) { follow(*base); },
      ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay());
  timer_ = private_node.createSteadyTimer(ros::WallDuration(WARN_MISSING_AFTER),
                                          [this](const ros::SteadyTimerEvent&)
                                          {
                                            if (!started_)
                                              ROS_WARN("%s is not running: waiting for it", sieve_.c_str());
                                          });
}

void ScheduleNode::beginAnew()
{
  // No warning if the sieve ends after the schedule is complete.
  if (next_ < schedule_.size())
    ROS_WARN("%s stopped at %.3f s, before the end of the schedule, which restarts when %s is back",
             sieve_.c_str(), last_time_, sieve_.c_str());
  started_ = base_seen_ = false;
  next_ = 0;
  last_time_ = 0.0;
}

void ScheduleNode::follow(const BaseState& base)
{
  base_seen_ = true;
  startOnceConnected();
  if (base.time < last_time_ && next_ > 0)
  {
    ROS_INFO("time jumped back from %.3f to %.3f s: the schedule restarts", last_time_, base.time);
    next_ = 0;
  }
  last_time_ = base.time;
  while (started_ && next_ < schedule_.size() && schedule_[next_].time <= base.time)
  {
    command(schedule_[next_++], base.time);
    if (next_ == schedule_.size())
      end(base.time);
  }
}

void ScheduleNode::end(double now)
{
  ROS_INFO("the schedule is over at %.3f s", now);
  if (exit_at_end_)
    timer_ = node_.createSteadyTimer(
        ros::WallDuration(LAST_SETPOINT_FLUSH_TIME), [](const ros::SteadyTimerEvent&) { ros::shutdown(); },
        true);
}

void ScheduleNode::command(const ScheduleEntry& entry, double now)
{
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
  {
    const auto& value = entry.values[indexOf(q.quantity)];
    if (!value)
      continue;
    std_msgs::Float64 message;
    message.data = *value;
    setpoints_[indexOf(q.quantity)].publish(message);
    ROS_INFO("%s %g, due at %.3f s, sent at %.3f s", q.name, message.data, entry.time, now);
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
  ROS_INFO("%s is running: the schedule starts", sieve_.c_str());
  std_srvs::Empty nothing;
  if (!unpause_.waitForExistence() || !unpause_.call(nothing))
    ROS_ERROR("%s cannot be called", unpause_.getService().c_str());
}

}  // namespace ratchet_sieve
