#pragma once

#include <algorithm>
#include <chrono>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// Divides a run into calls of advanceTo() that take about the same wall time, so that a caller can do
/// something else in between. The run does not depend on it.
class Stride
{
public:
  /// @param longest wall time of an advance, about [s]
  explicit Stride(double longest = 0.08) : longest_(longest) {}

  double length() const { return length_; }  ///< of simulated time [s]

  /// Learns from an advance by `simulated` [s] that took `wall` [s].
  void learn(double simulated, double wall)
  {
    if (wall > longest_)
      length_ = std::max(0.5 * length_, SHORTEST);
    else if (wall < 0.25 * longest_ && simulated >= 0.99 * length_)
      length_ = std::min(2.0 * length_, LONGEST);
  }

  /// Advances by a stride, or to an earlier time. @throws StallError
  void advance(Simulation& simulation, double until)
  {
    const double from = simulation.time();
    const auto start = std::chrono::steady_clock::now();
    simulation.advanceTo(std::min(until, from + length_));
    const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
    learn(simulation.time() - from, wall.count());
  }

private:
  static constexpr double LONGEST = 100.0;  ///< a light scene needs no more [s of simulated time]
  static constexpr double SHORTEST = 1e-7;  ///< lets the very heaviest scenes move on [s of simulated time]

  double longest_;
  double length_ = 1e-3;
};

}  // namespace ratchet_sieve
