#pragma once

#include <array>
#include <optional>
#include <string>

#include "ratchet_sieve/core/commanded_quantity.h"

namespace ratchet_sieve
{

/// The topic of a quantity's setpoints, in the sieve's namespace.
std::string setpointTopic(Quantity quantity);

/// The limits of one setpoint of a node.
struct Setpoint
{
  Quantity quantity = Quantity::INCLINATION;
  Interval limits;

  std::string name() const { return describe(quantity).name; }
  std::string unit() const { return describe(quantity).unit; }

  /// The reason why the value is refused, with the limits; nothing if the value is finite and within the
  /// limits.
  std::optional<std::string> refusal(double value) const;
};

/// The default limits of a node, in the order of Quantity.
std::array<Setpoint, QUANTITIES> usualSetpoints();

}  // namespace ratchet_sieve
