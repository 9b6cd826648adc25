#include "ratchet_sieve/ros/real_time_factor.h"

#include <ros/console.h>

#include "ratchet_sieve/ros/node_parameters.h"
#include "ratchet_sieve/ros/parameter_reader.h"

namespace ratchet_sieve
{
namespace
{
constexpr const char* NAME = "real_time_factor";

/// Interval between checks: short for a user, long compared to the cost [wall time].
constexpr std::chrono::duration<double> BETWEEN_LOOKS(0.02);

/// The value that the master sends for a deleted parameter.
bool isNothing(const XmlRpc::XmlRpcValue& value)
{
  return value.getType() == XmlRpc::XmlRpcValue::TypeStruct && value.size() == 0;
}
}  // namespace

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
    if (node_.getParamCached(NAME, value) && !isNothing(value))
    {
      const double factor = numberFrom(node_.resolveName(NAME), value, 0.0, MAX_REAL_TIME_FACTOR);
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
