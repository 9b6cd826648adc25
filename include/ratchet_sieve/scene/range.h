#pragma once

#include <limits>
#include <string>

namespace ratchet_sieve
{

/// The values that a number may have.
struct Range
{
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  const char* unit = "";

  bool holds(double value) const { return value >= lowest && value <= highest; }

  /// Such as "from 0 to 1000 m", "at least 0" or "finite".
  std::string text() const;
};

}  // namespace ratchet_sieve
