#include "ratchet_sieve/ros/node_parameters.h"

#include <algorithm>

#include <ros/console.h>

#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{
constexpr double MAX_SPLIT_SIZE = 1e6;  // MB
constexpr double MAX_DISTANCE = 1e6;    // m

/// @return the slew rate
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

void readRecording(ParameterReader& reader, RecordingParameters& recording)
{
  readRates(reader, "recording/", recording.rates);
  recording.split_size = reader.number("recording/split_size", recording.split_size, 0.0, MAX_SPLIT_SIZE);
  recording.split_duration =
      reader.number("recording/split_duration", recording.split_duration, 0.0, LONGEST_DURATION);
}

void readAllRates(ParameterReader& reader, NodeParameters& parameters)
{
  readRates(reader, "rates/", parameters.rates);
  parameters.display_rate = reader.number("rates/display", parameters.display_rate, 0.0, 1e3);
  parameters.clock_rate = reader.number("rates/clock", parameters.clock_rate, 1.0, 1e3);
}

double readMount(ParameterReader& reader, const char* axis)
{
  return reader.number(std::string("mount/") + axis, 0.0, -MAX_DISTANCE, MAX_DISTANCE);
}
}  // namespace

std::string readFramePrefix(ParameterReader& reader, const std::string& sieve)
{
  std::string prefix = reader.text("frame_prefix", defaultFramePrefix(sieve));
  const std::string error = framePrefixError(prefix);
  if (!error.empty())
    throw ParameterError("parameter " + reader.fullName("frame_prefix") + ": " + prefix + ": " + error);
  return prefix;
}

std::array<Setpoint, QUANTITIES> readSetpoints(ParameterReader& reader, SlewRates& slew_rates)
{
  std::array<Setpoint, QUANTITIES> setpoints = usualSetpoints();
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
  {
    double& slew_rate = slew_rates.*q.slew_rate;
    slew_rate = readSetpoint(reader, slew_rate, setpoints[indexOf(q.quantity)]);
  }
  return setpoints;
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
  readRecording(reader, parameters.recording);
  readAllRates(reader, parameters);
  parameters.setpoints = readSetpoints(reader, parameters.slew_rates);
  parameters.mount = {readMount(reader, "x"), readMount(reader, "y"), readMount(reader, "z")};
  parameters.frames =
      frameNames(readFramePrefix(reader, private_node.getNamespace()), parameters.mountedElsewhere());
  for (const std::string& name : reader.unknown({"scene", "scene_file", "set", "seed", "diagnostic_period"}))
    ROS_WARN("parameter %s: not known, and ignored", name.c_str());
  return parameters;
}

}  // namespace ratchet_sieve
