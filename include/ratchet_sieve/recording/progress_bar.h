#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// What this program has simulated of a run that it may have resumed.
struct Progress
{
  double simulated = 0.0;  ///< [s]
  std::uint64_t events = 0;
  double wall = 0.0;  ///< [s]

  /// Half-width over the requested half-width; see Certainty::ratio().
  std::optional<double> certainty_ratio = std::nullopt;
};

/// One line of a progress bar: simulated time, percent, events per second of wall time, upper bound of the
/// remaining time, statistical error.
std::string progressText(double time, double duration, const Progress& progress);

/// A progress bar on standard error, if that is a terminal. Redrawn at most ten times a second; erased at the
/// end.
class ProgressBar
{
public:
  /// @param start the run at the start of this program
  explicit ProgressBar(const Simulation& start);
  ~ProgressBar();

  void show(const Simulation& simulation);

private:
  double duration_;
  double start_time_;
  std::uint64_t start_events_;
  bool visible_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point next_;
};

/// A progress bar for the pour on standard error, if that is a terminal. Erased at the end.
class PourBar
{
public:
  PourBar();
  ~PourBar();
  PourBar(const PourBar&) = delete;
  PourBar& operator=(const PourBar&) = delete;

  void show(std::size_t poured, std::size_t of);

private:
  bool visible_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ratchet_sieve
