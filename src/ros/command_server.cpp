#include "command_server.h"

#include <type_traits>
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
  {
    const boost::function<void(const ros::MessageEvent<const std_msgs::Float64>&)> take =
        [this, setpoint](const auto& event) { takeSetpoint(setpoint, event); };
    subscribers_.push_back(private_node.subscribe<std_msgs::Float64>(setpointTopic(setpoint.quantity),
                                                                     QUEUE_SIZE, take, ros::VoidConstPtr(),
                                                                     ros::TransportHints().tcpNoDelay()));
  }
  offerServices(private_node);
  for (const SensorInfo& sensor : SENSOR_LIST)
    if (sensor.kind == SensorKind::SCALE && parameters.sensors.count(sensor.kind) > 0)
      offer<std_srvs::Trigger>(private_node, std::string(sensor.name) + "/tare",
                               [this, &sensor](auto&, auto& response)
                               {
                                 control_.tare(sensor.name);
                                 response.success = true;
                               });
}

/// Advertises a service. Setpoints received before its call are applied before it. @param handle of a request
/// and its response; may return whether it succeeded, where the response has no field for that
template <typename Service, typename Handle>
void CommandServer::offer(ros::NodeHandle& node, const std::string& name, const Handle& handle)
{
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> serve =
      [this, handle](Request& request, Response& response)
  {
    inbox_.deliver(false, [this](Quantity quantity, double value) { command(quantity, value); });
    bool success = true;
    if constexpr (std::is_void_v<decltype(handle(request, response))>)
      handle(request, response);
    else
      success = handle(request, response);
    time_changed_();
    return success;
  };
  services_.push_back(node.advertiseService(name, serve));
}

void CommandServer::offerServices(ros::NodeHandle& private_node)
{
  ros::NodeHandle interrupting(private_node);
  interrupting.setCallbackQueue(&interrupting_);
  offer<std_srvs::Empty>(interrupting, "pause_physics", [this](auto&, auto&) { control_.pause(); });
  offer<std_srvs::Empty>(interrupting, "unpause_physics", [this](auto&, auto&) { control_.unpause(); });
  offer<std_srvs::Empty>(interrupting, "reset_world", [this](auto&, auto&) { return resetWorld(); });
  offer<ResetSimulation>(interrupting, "reset",
                         [this](auto& request, auto& response) { reset(request, response); });
  offer<StepSimulation>(private_node, "step",
                        [this](auto& request, auto& response)
                        {
                          answer("step", control_.step(request.duration, stride_), response);
                          response.time = control_.run().time();
                        });
  offer<LockStep>(private_node, "lock_step",
                  [this](auto& request, auto& response) { lockStep(request, response); });
  offer<PourDisks>(private_node, "pour",
                   [this](auto& request, auto& response)
                   { answer("pour", control_.pour(request.species, request.count), response); });
  offer<PourBetween>(private_node, "pour_between",
                     [this](auto& request, auto& response)
                     {
                       const Stretch between{request.left, request.right};
                       answer("pour_between", control_.pour(request.species, request.count, between),
                              response);
                     });
  offer<SetFault>(private_node, "fault",
                  [this](auto& request, auto& response)
                  { answer("fault", control_.fault(request.part, request.fault), response); });
}

void CommandServer::takeSetpoint(const Setpoint& setpoint,
                                 const ros::MessageEvent<const std_msgs::Float64>& event)
{
  const double value = event.getConstMessage()->data;
  SetpointLog& log = logs_[indexOf(setpoint.quantity)];
  if (const auto refusal = setpoint.refusal(value))
  {
    say(ros::console::levels::Warn, log.refused.put(*refusal, LogThrottle::Clock::now()));
    diagnostics_.answered(setpoint.name(), *refusal);
    return;
  }
  diagnostics_.answered(setpoint.name());
  log.publisher = event.getPublisherName();
  inbox_.put(setpoint.quantity, value);
}

void CommandServer::serve(double wait)
{
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(wait));
  if (!interrupting_.isEmpty())
  {
    // Setpoints that came during a step came before the call that ended it.
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.0));
    interrupting_.callAvailable();
  }
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
  SetpointLog& log = logs_[indexOf(quantity)];
  const std::string line = fmt::format("{}: {:g} {} from {:.3f} s on, by {}", describe(quantity).name, value,
                                       describe(quantity).unit, control_.run().time(), log.publisher);
  if (std::exchange(log.told, log.publisher) == log.publisher)
    ROS_DEBUG_STREAM(line);
  else
    say(ros::console::levels::Info, log.taken.put(line, LogThrottle::Clock::now()));
}

bool CommandServer::resetWorld()
{
  const Outcome outcome = control_.resetWorld();
  if (!outcome.success)
  {
    ROS_ERROR("reset_world: %s", outcome.message.c_str());
    diagnostics_.answered("reset_world", outcome.message);
    return false;
  }
  diagnostics_.answered("reset_world");
  ROS_INFO("new disks poured at %.3f s", control_.run().time());
  return true;
}

void CommandServer::reset(const ResetSimulation::Request& request, ResetSimulation::Response& response)
{
  answer("reset", control_.reset(request.seed, request.overrides, request.keep_time), response);
  if (!response.success)
    return;
  diagnostics_.answered("reset_world");
  ROS_INFO("reset: new run from %g s with seed %lu", control_.run().time(),
           static_cast<unsigned long>(control_.run().simulation().scene().seed));
}

void CommandServer::lockStep(const LockStep::Request& request, LockStep::Response& response)
{
  std::vector<std::pair<std::string, double>> setpoints;
  for (const BaseSetpoint& setpoint : request.setpoints)
    setpoints.emplace_back(setpoint.quantity, setpoint.value);
  answer("lock_step", control_.lockStep(setpoints, request.duration, stride_), response);
  const Run& run = control_.run();
  response.time = run.time();
  response.finished = run.finished();
  response.base = toMessage(run.now<BaseFrame>(), frame_id_);
  response.bins = toMessage(run.now<BinFrame>(), frame_id_);
  response.statistics = toMessage(run.now<StatisticsFrame>(), frame_id_);
}

}  // namespace ratchet_sieve
