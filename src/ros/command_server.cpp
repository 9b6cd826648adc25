#include "ratchet_sieve/ros/command_server.h"

#include <utility>

#include <fmt/format.h>
#include <ros/console.h>

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

void say(ros::console::levels::Level level, const std::optional<std::string>& line)
{
  if (line)
    ROS_LOG_STREAM(level, ROSCONSOLE_DEFAULT_NAME, *line);
}

double commanded(SetpointKind kind, const DriveState& base)
{
  switch (kind)
  {
    case SetpointKind::INCLINATION:
      return base.commanded_inclination;
    case SetpointKind::FREQUENCY:
      return base.commanded_frequency;
    case SetpointKind::AMPLITUDE:
      return base.commanded_amplitude;
  }
  return 0.0;
}
}  // namespace

CommandServer::CommandServer(ros::NodeHandle private_node, const NodeParameters& parameters,
                             RunControl& control, Diagnostics& diagnostics, Stepping stepping,
                             std::function<void()> time_changed)
    : control_(control),
      diagnostics_(diagnostics),
      stepping_(std::move(stepping)),
      time_changed_(std::move(time_changed)),
      setpoints_(parameters.setpoints)
{
  for (const Setpoint& setpoint : setpoints_)
    subscribers_.push_back(private_node.subscribe<std_msgs::Float64>(
        setpoint.topic(), QUEUE_SIZE,
        [this, setpoint](const std_msgs::Float64::ConstPtr& message) { takeSetpoint(setpoint, *message); },
        ros::VoidConstPtr(), ros::TransportHints().tcpNoDelay()));
  services_ = {private_node.advertiseService("pause_physics", &CommandServer::pause, this),
               private_node.advertiseService("unpause_physics", &CommandServer::unpause, this),
               private_node.advertiseService("reset_world", &CommandServer::resetWorld, this),
               private_node.advertiseService("reset", &CommandServer::reset, this),
               private_node.advertiseService("step", &CommandServer::step, this),
               private_node.advertiseService("pour", &CommandServer::pour, this)};
}

void CommandServer::takeSetpoint(const Setpoint& setpoint, const std_msgs::Float64& message)
{
  if (const auto refusal = setpoint.refusal(message.data))
  {
    LogThrottle& log = logs_[static_cast<std::size_t>(setpoint.kind)].refused;
    say(ros::console::levels::Warn, log.put(*refusal, LogThrottle::Clock::now()));
    diagnostics_.setpointRefused(setpoint, *refusal);
    return;
  }
  diagnostics_.setpointTaken(setpoint);
  inbox_.put(setpoint.kind, message.data);
}

void CommandServer::deliverSetpoints()
{
  const auto now = LogThrottle::Clock::now();
  for (SetpointLog& log : logs_)
  {
    say(ros::console::levels::Info, log.taken.due(now));
    say(ros::console::levels::Warn, log.refused.due(now));
  }
  inbox_.deliver(!control_.paused(), [this](SetpointKind kind, double value) { command(kind, value); });
}

void CommandServer::command(SetpointKind kind, double value)
{
  // A controller that says the same again and again wants nothing new.
  if (commanded(kind, control_.run().simulation().base()) == value)
    return;
  const Setpoint& setpoint = setpoints_[static_cast<std::size_t>(kind)];
  const Outcome outcome = control_.command(setpoint, value);
  if (!outcome.success)
    ROS_WARN("%s", outcome.message.c_str());
  LogThrottle& log = logs_[static_cast<std::size_t>(kind)].taken;
  const std::string line =
      fmt::format("{}: {:g} {} from {:.3f} s on", setpoint.name, value, setpoint.unit, control_.run().time());
  if (outcome.success)
    say(ros::console::levels::Info, log.put(line, LogThrottle::Clock::now()));
}

/// What came before a service was called holds before it.
void CommandServer::commandAll()
{
  inbox_.deliver(false, [this](SetpointKind kind, double value) { command(kind, value); });
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
  control_.resetWorld();
  time_changed_();
  ROS_INFO("disks poured anew at %.3f s", control_.run().time());
  return true;
}

bool CommandServer::reset(ResetSimulation::Request& request, ResetSimulation::Response& response)
{
  commandAll();
  answer("reset", control_.reset(request.seed, request.overrides), response);
  time_changed_();
  if (response.success)
    ROS_INFO("begun anew with seed %lu",
             static_cast<unsigned long>(control_.run().simulation().scene().seed));
  return true;
}

bool CommandServer::step(StepSimulation::Request& request, StepSimulation::Response& response)
{
  commandAll();
  answer("step", control_.step(request.duration, stepping_.stride(), stepping_.keep_going), response);
  time_changed_();
  response.time = control_.run().time();
  return true;
}

bool CommandServer::pour(PourDisks::Request& request, PourDisks::Response& response)
{
  commandAll();
  answer("pour", control_.pour(request.species, request.count), response);
  return true;
}

}  // namespace ratchet_sieve
