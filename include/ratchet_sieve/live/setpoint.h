#pragma once

#include <array>
#include <optional>
#include <string>

#include "ratchet_sieve/core/commanded_quantity.h"

namespace ratchet_sieve
{

/// The topic of a quantity's setpoints, in the sieve's namespace.
std::string setpointTopic(Quantity quantity);

/// One quantity of the base as a node takes it.
struct Setpoint
{
  Quantity quantity = Quantity::INCLINATION;
  Interval limits;

  std::string name() const { return describe(quantity).name; }
  std::string unit() const { return describe(quantity).unit; }

  /// Why the value is refused, with the numbers; nothing if it is finite and within the limits.
  std::optional<std::string> refusal(double value) const;
};

/// What a node takes unless its parameters say otherwise, in the order of Quantity.
std::array<Setpoint, QUANTITIES> usualSetpoints();

}  // namespace ratchet_sieve
