#include "node_parameters.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include <ros/console.h>

#include "ratchet_sieve/live/plant.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "scene_parameters.h"

namespace ratchet_sieve
{
namespace
{
/// Largest real-time factor; for a faster run, use 0 (as fast as possible).
constexpr double MAX_REAL_TIME_FACTOR = 1e6;

constexpr double MAX_SPLIT_SIZE = 1e6;    // MB
constexpr double SHORTEST_WINDOW = 1e-3;  // s
constexpr double MAX_DISTANCE = 1e6;      // m

/// Interval between checks of ~real_time_factor: short for a user, long compared to the cost [wall time].
constexpr std::chrono::duration<double> BETWEEN_LOOKS(0.02);

[[noreturn]] void refuse(const std::string& name, const XmlRpc::XmlRpcValue& value,
                         const std::string& allowed)
{
  using ::operator<<;  // the messages' operators would hide it
  std::ostringstream text;
  text << "parameter " << name << ": " << value << ": must be " << allowed;
  throw ParameterError(text.str());
}

/// A parameter's value, if it is a finite number in [least, most]. @param name full name
/// @throws ParameterError
double numberFrom(const std::string& name, XmlRpc::XmlRpcValue value, double least, double most)
{
  std::ostringstream allowed;
  allowed << "a number from " << least << " to " << most;
  double number = 0.0;
  if (value.getType() == XmlRpc::XmlRpcValue::TypeDouble)
    number = static_cast<double&>(value);
  else if (value.getType() == XmlRpc::XmlRpcValue::TypeInt)
    number = static_cast<int&>(value);
  else
    refuse(name, value, allowed.str());
  if (!std::isfinite(number) || number < least || number > most)
    refuse(name, value, allowed.str());
  return number;
}

/// Reads the limits of a setpoint. @return its slew rate
double readSetpoint(ParameterReader& reader, double slew_rate, Setpoint& setpoint)
{
  const CommandedQuantity& q = describe(setpoint.quantity);
  const std::string prefix = std::string("limits/") + q.name + "/";
  setpoint.limits.min =
      reader.number(prefix + "min", setpoint.limits.min, q.widest_limits.min, q.widest_limits.max);
  // A lower limit above the default upper limit raises the upper limit; otherwise no value would be allowed.
  const double usual = std::max(setpoint.limits.max, setpoint.limits.min);
  setpoint.limits.max = reader.number(prefix + "max", usual, setpoint.limits.min, q.widest_limits.max);
  return reader.number(prefix + "slew_rate", slew_rate, q.slew_rates.min, q.slew_rates.max);
}

void readRates(ParameterReader& reader, const std::string& prefix, FrameRates& rates)
{
  for (const FrameKindInfo& kind : FRAME_LIST)
    if (kind.rate != nullptr)
      rates.*kind.rate = reader.number(prefix + kind.name, rates.*kind.rate, 0.0, MAX_FRAME_RATE);
}

/// Reads a tree of parameters, if it is set. @throws SceneError
template <typename Parameters>
void readTree(const ros::NodeHandle& node, const char* name,
              Parameters (*read)(const YAML::Node&, const std::string&), Parameters& parameters)
{
  XmlRpc::XmlRpcValue value;
  const std::string source = "parameter " + node.resolveName(name);
  if (node.getParam(name, value))
    parameters = read(yamlFromParameter(value, source), source);
}
}  // namespace

double ParameterReader::number(const std::string& name, double fallback, double least, double most)
{
  XmlRpc::XmlRpcValue value;
  return isSet(name, value) ? numberFrom(fullName(name), value, least, most) : fallback;
}

std::size_t ParameterReader::count(const std::string& name, std::size_t fallback, std::size_t most)
{
  const std::string allowed = "a whole number from 0 to " + std::to_string(most);
  const int number = read(name, static_cast<int>(fallback), XmlRpc::XmlRpcValue::TypeInt, allowed);
  if (number < 0 || static_cast<std::size_t>(number) > most)
    refuse(fullName(name), number, allowed);
  return static_cast<std::size_t>(number);
}

bool ParameterReader::isSet(const std::string& name, XmlRpc::XmlRpcValue& value)
{
  asked_.insert(name);
  return node_.getParam(name, value);
}

template <typename T>
T ParameterReader::read(const std::string& name, const T& fallback, XmlRpc::XmlRpcValue::Type type,
                        const std::string& allowed)
{
  XmlRpc::XmlRpcValue value;
  if (!isSet(name, value))
    return fallback;
  if (value.getType() != type)
    refuse(fullName(name), value, allowed);
  return static_cast<T&>(value);
}

bool ParameterReader::flag(const std::string& name, bool fallback)
{
  return read(name, fallback, XmlRpc::XmlRpcValue::TypeBoolean, "true or false");
}

std::string ParameterReader::text(const std::string& name, const std::string& fallback)
{
  return read(name, fallback, XmlRpc::XmlRpcValue::TypeString, "text");
}

std::set<std::string> ParameterReader::unknown(const std::set<std::string>& ignored) const
{
  const std::string prefix = node_.getNamespace() + "/";
  std::vector<std::string> names;
  node_.getParamNames(names);
  std::set<std::string> unknown;
  for (const std::string& full_name : names)
  {
    if (full_name.compare(0, prefix.size(), prefix) != 0)
      continue;
    const std::string name = full_name.substr(prefix.size());
    const std::string first = name.substr(0, name.find('/'));
    if (asked_.count(name) == 0 && ignored.count(first) == 0)
      unknown.insert(full_name);
  }
  return unknown;
}

std::string readFramePrefix(ParameterReader& reader, const std::string& sieve)
{
  std::string prefix = reader.text("frame_prefix", defaultFramePrefix(sieve));
  const std::string error = framePrefixError(prefix);
  if (!error.empty())
    throw ParameterError("parameter " + reader.fullName("frame_prefix") + ": " + prefix + ": " + error);
  return prefix;
}

NodeParameters readNodeParameters(const ros::NodeHandle& private_node)
{
  NodeParameters parameters;
  ParameterReader reader(private_node);
  parameters.real_time_factor =
      reader.number("real_time_factor", parameters.real_time_factor, 0.0, MAX_REAL_TIME_FACTOR);
  parameters.start_paused = reader.flag("start_paused", parameters.start_paused);
  parameters.threads = reader.count("threads", parameters.threads, MOST_THREADS);
  parameters.publish_clock = reader.flag("publish_clock", parameters.publish_clock);
  parameters.exit_at_end = reader.flag("exit_at_end", parameters.exit_at_end);
  parameters.record = reader.text("record", parameters.record);
  readRates(reader, "recording/", parameters.recording.rates);
  parameters.recording.split_size = reader.number("recording/split_size", 0.0, 0.0, MAX_SPLIT_SIZE);
  parameters.recording.split_duration = reader.number("recording/split_duration", 0.0, 0.0, LONGEST_DURATION);
  parameters.window = reader.number("window", parameters.window, SHORTEST_WINDOW, LONGEST_DURATION);
  readRates(reader, "rates/", parameters.rates);
  parameters.display_rate = reader.number("rates/display", parameters.display_rate, 0.0, MAX_WALL_RATE);
  parameters.clock_rate = reader.number("rates/clock", parameters.clock_rate, 1.0, MAX_WALL_RATE);
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
  {
    double& slew_rate = parameters.slew_rates.*q.slew_rate;
    slew_rate = readSetpoint(reader, slew_rate, parameters.setpoints[indexOf(q.quantity)]);
  }
  readTree(private_node, "actuators", readDrives, parameters.drives);
  readTree(private_node, "sensors", readSensors, parameters.sensors);
  for (std::size_t k = 0; k < parameters.mount.size(); ++k)
    parameters.mount[k] = reader.number(std::string("mount/") + "xyz"[k], 0.0, -MAX_DISTANCE, MAX_DISTANCE);
  parameters.frames =
      frameNames(readFramePrefix(reader, private_node.getNamespace()), parameters.mountedElsewhere());
  for (const std::string& name :
       reader.unknown({"scene", "scene_file", "set", "seed", "diagnostic_period", "actuators", "sensors"}))
    ROS_WARN("parameter %s: not known, and ignored", name.c_str());
  return parameters;
}

RealTimeFactor::RealTimeFactor(const ros::NodeHandle& private_node, double present)
    : node_(private_node), present_(present)
{
}

std::optional<double> RealTimeFactor::changed()
{
  const auto now = Clock::now();
  if (now - last_look_ < BETWEEN_LOOKS)
    return std::nullopt;
  last_look_ = now;
  std::string refusal;
  std::optional<double> change;
  XmlRpc::XmlRpcValue value;
  try
  {
    // The master sends an empty tree for a deleted parameter.
    if (node_.getParamCached("real_time_factor", value) &&
        !(value.getType() == XmlRpc::XmlRpcValue::TypeStruct && value.size() == 0))
    {
      const double factor =
          numberFrom(node_.resolveName("real_time_factor"), value, 0.0, MAX_REAL_TIME_FACTOR);
      if (factor != present_)
        change = present_ = factor;
    }
  }
  catch (const ParameterError& error)
  {
    refusal = error.what();
    if (refusal != refusal_)
      ROS_WARN("%s; %g stays", refusal.c_str(), present_);
  }
  refusal_ = refusal;
  return change;
}

}  // namespace ratchet_sieve
