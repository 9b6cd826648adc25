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

/// `0:07`, `1:02:03`, `10 days`.
std::string durationText(double seconds);

/// One line of a progress bar: simulated time, percent, events per second of wall time, upper bound of the
/// remaining time, statistical error. The bar takes what these leave of the width [characters].
std::string progressText(double time, double duration, const Progress& progress, std::size_t width = 120);

/// A progress bar on standard error, if that is a terminal, whose width cuts it. Redrawn at most ten times a
/// second; erased at the end.
class ProgressBar
{
public:
  ProgressBar();
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  bool isVisible() const { return visible_; }

  /// Any line.
  void show(const std::string& line);

  /// Of a pour.
  void show(std::size_t poured, std::size_t of);

  /// Of a run, whose speed is counted from the first call on.
  void show(const Simulation& simulation);

private:
  bool isDue();
  void draw(const std::string& line) const;

  using Clock = std::chrono::steady_clock;
  bool visible_;
  Clock::time_point start_ = Clock::now();
  Clock::time_point next_ = start_;
  std::optional<double> start_time_;  ///< of the run [s]
  std::uint64_t start_events_ = 0;
};

}  // namespace ratchet_sieve
