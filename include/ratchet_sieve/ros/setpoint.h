#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// Where a setpoint may lie.
struct SetpointLimits
{
  double min = 0.0;
  double max = 0.0;
};

/// One quantity of the base that is commanded.
struct Setpoint
{
  CommandKind kind = CommandKind::INCLINATION;
  std::string name;  ///< inclination, frequency or amplitude
  std::string unit;  ///< rad, Hz or m
  SetpointLimits limits;

  std::string topic() const { return name + "_setpoint"; }

  /// Why the value is refused, with the numbers; nothing if it is finite and within the limits.
  std::optional<std::string> refusal(double value) const;
};

}  // namespace ratchet_sieve
