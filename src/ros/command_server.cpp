#include "command_server.h"

#include <utility>

#include <fmt/format.h>
#include <ros/console.h>

namespace ratchet_sieve
{
namespace
{
/// Copies an outcome into a service's response, and logs it.
template <typename Response>
void answer(const char* service, const Outcome& outcome, Response& response)
{
  response.success = outcome.success;
  response.message = outcome.message;
  if (!outcome.success)
    ROS_WARN("%s: %s", service, outcome.message.c_str());
  else if (!outcome.message.empty())
    ROS_INFO("%s: %s", service, outcome.message.c_str());
}

void say(ros::console::levels::Level level, const std::optional<std::string>& line)
{
  if (line)
    ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME, *line);
}
}  // namespace

CommandServer::CommandServer(ros::NodeHandle private_node, const NodeParameters& parameters,
                             RunControl& control, Diagnostics& diagnostics, RunControl::Stride stride,
                             std::function<void()> time_changed)
    : control_(control),
      diagnostics_(diagnostics),
      stride_([this, stride = std::move(stride)](double time)
              { return interrupting_.isEmpty() && stride(time); }),
      time_changed_(std::move(time_changed)),
      frame_id_(parameters.frames.world)
{
  for (const Setpoint& setpoint : parameters.setpoints)
    subscribers_.push_back(private_node.subscribe<std_msgs::Float64>(
        setpointTopic(setpoint.quantity), QUEUE_SIZE,
        [this, setpoint](const std_msgs::Float64::ConstPtr& message) { takeSetpoint(setpoint, *message); },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  ros::NodeHandle interrupting_node(private_node);
  interrupting_node.setCallbackQueue(&interrupting_);
  services_ = {interrupting_node.advertiseService("pause_physics", &CommandServer::pause, this),
               interrupting_node.advertiseService("unpause_physics", &CommandServer::unpause, this),
               interrupting_node.advertiseService("reset_world", &CommandServer::resetWorld, this),
               interrupting_node.advertiseService("reset", &CommandServer::reset, this),
               private_node.advertiseService("step", &CommandServer::step, this),
               private_node.advertiseService("lock_step", &CommandServer::lockStep, this),
               private_node.advertiseService("pour", &CommandServer::pour, this)};
}

void CommandServer::takeSetpoint(const Setpoint& setpoint, const std_msgs::Float64& message)
{
  if (const auto refusal = setpoint.refusal(message.data))
  {
    LogThrottle& log = logs_[indexOf(setpoint.quantity)].refused;
    say(ros::console::levels::Warn, log.put(*refusal, LogThrottle::Clock::now()));
    diagnostics_.setpointRefused(setpoint, *refusal);
    return;
  }
  diagnostics_.setpointTaken(setpoint);
  inbox_.put(setpoint.quantity, message.data);
}

void CommandServer::serve(double wait)
{
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(wait));
  interrupting_.callAvailable();
  const auto now = LogThrottle::Clock::now();
  for (SetpointLog& log : logs_)
  {
    say(ros::console::levels::Info, log.taken.due(now));
    say(ros::console::levels::Warn, log.refused.due(now));
  }
  inbox_.deliver(!control_.paused(), [this](Quantity quantity, double value) { command(quantity, value); });
}

void CommandServer::command(Quantity quantity, double value)
{
  // Repeating the commanded value changes nothing.
  if (control_.commanded(quantity) == value)
    return;
  control_.command(quantity, value);
  LogThrottle& log = logs_[indexOf(quantity)].taken;
  const std::string line = fmt::format("{}: {:g} {} from {:.3f} s on", describe(quantity).name, value,
                                       describe(quantity).unit, control_.run().time());
  say(ros::console::levels::Info, log.put(line, LogThrottle::Clock::now()));
}

/// Setpoints received before a service was called are applied before it.
void CommandServer::commandAll()
{
  inbox_.deliver(false, [this](Quantity quantity, double value) { command(quantity, value); });
}

bool CommandServer::pause(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  commandAll();
  control_.pause();
  time_changed_();
  return true;
}

bool CommandServer::unpause(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  commandAll();
  control_.unpause();
  time_changed_();
  return true;
}

bool CommandServer::resetWorld(std_srvs::Empty::Request&, std_srvs::Empty::Response&)
{
  commandAll();
  const Outcome outcome = control_.resetWorld();
  time_changed_();
  if (!outcome.success)
  {
    // The response has no field for the reason.
    ROS_ERROR("reset_world: %s", outcome.message.c_str());
    diagnostics_.resetWorldRefused(outcome.message);
    return false;
  }
  diagnostics_.begunAnew();
  ROS_INFO("new disks poured at %.3f s", control_.run().time());
  return true;
}

bool CommandServer::reset(ResetSimulation::Request& request, ResetSimulation::Response& response)
{
  commandAll();
  answer("reset", control_.reset(request.seed, request.overrides, request.keep_time), response);
  time_changed_();
  if (!response.success)
    return true;
  diagnostics_.begunAnew();
  ROS_INFO("reset: new run from %g s with seed %lu", control_.run().time(),
           static_cast<unsigned long>(control_.run().simulation().scene().seed));
  return true;
}

bool CommandServer::step(StepSimulation::Request& request, StepSimulation::Response& response)
{
  commandAll();
  answer("step", control_.step(request.duration, stride_), response);
  time_changed_();
  response.time = control_.run().time();
  return true;
}

bool CommandServer::lockStep(LockStep::Request& request, LockStep::Response& response)
{
  commandAll();
  std::vector<std::pair<std::string, double>> setpoints;
  for (const BaseSetpoint& setpoint : request.setpoints)
    setpoints.emplace_back(setpoint.quantity, setpoint.value);
  answer("lock_step", control_.lockStep(setpoints, request.duration, stride_), response);
  time_changed_();
  const Run& run = control_.run();
  response.time = run.time();
  response.finished = run.finished();
  response.base = toMessage(run.base(), frame_id_);
  response.bins = toMessage(run.bins(), frame_id_);
  response.statistics = toMessage(run.statistics(), frame_id_);
  return true;
}

bool CommandServer::pour(PourDisks::Request& request, PourDisks::Response& response)
{
  commandAll();
  answer("pour", control_.pour(request.species, request.count), response);
  return true;
}

}  // namespace ratchet_sieve
