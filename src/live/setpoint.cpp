#include "ratchet_sieve/live/setpoint.h"

#include <cmath>
#include <sstream>

namespace ratchet_sieve
{

std::string setpointTopic(Quantity quantity)
{
  return describe(quantity).name + std::string("_setpoint");
}

std::optional<std::string> Setpoint::refusal(double value) const
{
  if (limits.contains(value))
    return std::nullopt;
  std::ostringstream text;
  // Without the sign of a NaN, which has no meaning.
  text << setpointTopic(quantity) << " " << (std::isnan(value) ? std::abs(value) : value) << " " << unit()
       << " refused: must be from " << limits.min << " to " << limits.max << " " << unit();
  return text.str();
}

std::array<Setpoint, QUANTITIES> usualSetpoints()
{
  std::array<Setpoint, QUANTITIES> setpoints;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    setpoints[indexOf(q.quantity)] = {q.quantity, q.usual};
  return setpoints;
}

}  // namespace ratchet_sieve
