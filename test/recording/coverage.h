#pragma once

#include <cmath>

namespace ratchet_sieve
{

/// Counts how often intervals contained the true value.
struct Coverage
{
  int held = 0;
  int of = 0;

  void take(bool holds)
  {
    held += holds ? 1 : 0;
    ++of;
  }
  double share() const { return static_cast<double>(held) / of; }

  /// Three standard deviations of the fraction, if it is as claimed.
  double tolerance(double claimed) const { return 3.0 * std::sqrt(claimed * (1.0 - claimed) / of); }
};

}  // namespace ratchet_sieve
