#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

#include "ratchet_sieve/sweep/best_setting.h"

namespace ratchet_sieve
{

/// The progress of a sweep.
struct SweepProgress
{
  std::uint64_t cases = 0;
  std::uint64_t done = 0;
  std::uint64_t failed = 0;
  std::uint64_t warned = 0;  ///< successful, with a warning
  std::uint64_t running = 0;
  std::uint64_t finished_here = 0;  ///< successful or failed since this process began
  double wall = 0.0;                ///< wall time since then [s]
  std::optional<SettingMean> best;  ///< so far
};

/// One line: done, running, failed, with warnings, rate, time left, the best mean Q so far.
std::string sweepProgressText(const SweepProgress& progress);

/// `0:07`, `1:02:03`.
std::string durationText(double seconds);

/// The progress line on standard error, if that is a terminal. Redrawn at most ten times a second; erased at
/// the end.
class SweepProgressLine
{
public:
  SweepProgressLine();
  ~SweepProgressLine();
  SweepProgressLine(const SweepProgressLine&) = delete;
  SweepProgressLine& operator=(const SweepProgressLine&) = delete;

  bool isVisible() const { return visible_; }
  void show(const SweepProgress& progress);

private:
  bool visible_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ratchet_sieve
