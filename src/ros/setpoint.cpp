#include "ratchet_sieve/ros/setpoint.h"

#include <cmath>
#include <sstream>

namespace ratchet_sieve
{

std::optional<std::string> Setpoint::refusal(double value) const
{
  if (std::isfinite(value) && value >= limits.min && value <= limits.max)
    return std::nullopt;
  std::ostringstream text;
  // The sign of a NaN says nothing.
  text << topic() << " " << (std::isnan(value) ? std::abs(value) : value) << " " << unit
       << " refused: must be from " << limits.min << " to " << limits.max << " " << unit;
  return text.str();
}

}  // namespace ratchet_sieve
