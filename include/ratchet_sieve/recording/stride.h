#pragma once

#include <algorithm>
#include <chrono>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// Divides a run into calls of advanceTo() that take some hundredths of a second of wall time, so that a
/// caller can do something else in between. The run does not depend on it.
class Stride
{
public:
  /// The time to which advance() would go [s].
  double end(const Simulation& simulation) const { return simulation.time() + length_; }

  /// Advances to the end of the stride, or to an earlier time. @throws StallError
  void advance(Simulation& simulation, double until)
  {
    const double end = this->end(simulation);
    const auto start = std::chrono::steady_clock::now();
    simulation.advanceTo(std::min(until, end));
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    if (taken > LONG)
      length_ *= 0.5;
    else if (until >= end && taken < SHORT)
      length_ *= 2.0;
  }

private:
  static constexpr std::chrono::duration<double> SHORT{0.02};  ///< shorter strides are lengthened
  static constexpr std::chrono::duration<double> LONG{0.08};   ///< longer ones are shortened

  double length_ = 1e-3;  ///< of simulated time [s]
};

}  // namespace ratchet_sieve
