#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// One line of a progress bar: simulated time, percent, events per second of wall time, time to go.
/// @param wall_seconds since the start [s]
std::string progressText(double time, double duration, std::uint64_t events, double wall_seconds);

/// A progress bar on standard error, where that is a terminal; else nothing. Redrawn ten times a
/// second at most, wiped away at its end.
class ProgressBar
{
public:
  explicit ProgressBar(double duration);
  ~ProgressBar();

  void show(const Simulation& simulation);

private:
  double duration_;
  bool visible_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ratchet_sieve
