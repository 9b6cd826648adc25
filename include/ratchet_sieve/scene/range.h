#pragma once

#include <cmath>
#include <limits>
#include <string>

namespace ratchet_sieve
{

/// The values that a number may have: between two bounds, both included, or any.
struct Range
{
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  const char* unit = "";

  bool isBounded() const { return std::isfinite(lowest) && std::isfinite(highest); }
  bool holds(double value) const { return value >= lowest && value <= highest; }

  /// Such as "0 to 1000", or "any".
  std::string values() const;

  /// Such as "from 0 to 1000 m", or "that is finite".
  std::string text() const;
};

}  // namespace ratchet_sieve
