#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// What a program has done of a run, which it may have taken up in the middle.
struct Progress
{
  double simulated = 0.0;  ///< [s]
  std::uint64_t events = 0;
  double wall = 0.0;  ///< [s]

  /// The half-width of what the run is to be sure of over the one that it asks for; see Certainty::ratio().
  std::optional<double> certainty_ratio = std::nullopt;
};

/// One line of a progress bar: simulated time, percent, events per second of wall time, time to go at most,
/// how sure.
std::string progressText(double time, double duration, const Progress& progress);

/// A progress bar on standard error, where that is a terminal; else nothing. Redrawn ten times a
/// second at most, wiped away at its end.
class ProgressBar
{
public:
  /// @param start the run to be shown, as this program begins with it
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

/// Shows on standard error how far the pour is, where that is a terminal. Disappears at its end.
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
