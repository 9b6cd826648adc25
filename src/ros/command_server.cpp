#include "ratchet_sieve/ros/command_server.h"

#include <utility>

#include <ros/console.h>

#include "ratchet_sieve/ros/conversions.h"

namespace ratchet_sieve
{
namespace
{
constexpr std::uint32_t QUEUE_SIZE = 100;

/// Copies how it went into a service's answer, and says so in the log if it did not.
template <typename Response>
void answer(const char* service, const Outcome& outcome, Response& response)
{
  response.success = outcome.success;
  response.message = outcome.message;
  if (!outcome.success)
    ROS_WARN("%s: %s", service, outcome.message.c_str());
}
}  // namespace

CommandServer::CommandServer(ros::NodeHandle private_node, const NodeParameters& parameters,
                             RunControl& control, Diagnostics& diagnostics, Stepping stepping,
                             std::function<void()> time_changed)
    : control_(control),
      diagnostics_(diagnostics),
      stepping_(std::move(stepping)),
      time_changed_(std::move(time_changed))
{
  for (const Setpoint& setpoint : parameters.setpoints)
    subscribers_.push_back(private_node.subscribe<std_msgs::Float64>(
        setpoint.topic(), QUEUE_SIZE,
        [this, setpoint](const std_msgs::Float64::ConstPtr& message) { takeSetpoint(setpoint, *message); },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  services_ = {private_node.advertiseService("pause_physics", &CommandServer::pause, this),
               private_node.advertiseService("unpause_physics", &CommandServer::unpause, this),
               private_node.advertiseService("reset_world", &CommandServer::resetWorld, this),
               private_node.advertiseService("reset", &CommandServer::reset, this),
               private_node.advertiseService("step", &CommandServer::step, this),
               private_node.advertiseService("lock_step", &CommandServer::lockStep, this),
               private_node.advertiseService("pour", &CommandServer::pour, this)};
}

void CommandServer::takeSetpoint(const Setpoint& setpoint, const std_msgs::Float64& message)
{
  const Outcome outcome = control_.command(setpoint, message.data);
  if (outcome.success)
  {
    ROS_INFO("%s: %g %s from %.3f s on", setpoint.name.c_str(), message.data, setpoint.unit.c_str(),
             control_.run().time());
    diagnostics_.setpointTaken(setpoint);
    return;
  }
  ROS_WARN("%s", outcome.message.c_str());
  diagnostics_.setpointRefused(setpoint, outcome.message);
}

bool CommandServer::pause(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  control_.pause();
  time_changed_();
  return true;
}

bool CommandServer::unpause(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  control_.unpause();
  time_changed_();
  return true;
}

bool CommandServer::resetWorld(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  control_.resetWorld();
  time_changed_();
  ROS_INFO("disks poured anew at %.3f s", control_.run().time());
  return true;
}

bool CommandServer::reset(ResetSimulation::Request& request, ResetSimulation::Response& response)
{
  answer("reset", control_.reset(request.seed, request.overrides, request.keep_time), response);
  time_changed_();
  if (response.success)
    ROS_INFO("begun anew at %g s with seed %lu", control_.run().time(),
             static_cast<unsigned long>(control_.run().simulation().scene().seed));
  return true;
}

bool CommandServer::step(StepSimulation::Request& request, StepSimulation::Response& response)
{
  answer("step", control_.step(request.duration, stepping_.stride(), stepping_.keep_going), response);
  time_changed_();
  response.time = control_.run().time();
  return true;
}

bool CommandServer::lockStep(LockStep::Request& request, LockStep::Response& response)
{
  std::vector<std::pair<std::string, double>> setpoints;
  for (const BaseSetpoint& setpoint : request.setpoints)
    setpoints.emplace_back(setpoint.quantity, setpoint.value);
  answer("lock_step",
         control_.lockStep(setpoints, request.duration, stepping_.stride(), stepping_.keep_going), response);
  time_changed_();
  const LiveRun& run = control_.run();
  response.time = run.time();
  response.finished = run.finished();
  response.base = toMessage(run.base());
  response.bins = toMessage(run.bins());
  response.statistics = toMessage(run.statistics());
  return true;
}

bool CommandServer::pour(PourDisks::Request& request, PourDisks::Response& response)
{
  answer("pour", control_.pour(request.species, request.count), response);
  return true;
}

}  // namespace ratchet_sieve
