#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// How far a sweep is.
struct SweepProgress
{
  std::uint64_t cases = 0;
  std::uint64_t done = 0;
  std::uint64_t failed = 0;
  std::uint64_t running = 0;
  std::uint64_t finished_here = 0;  ///< done or failed since this process began
  double wall = 0.0;                ///< since then [s]
  std::optional<double> best_quality;
};

/// One line: done, running, failed, rate, time left, best Q so far.
std::string sweepProgressText(const SweepProgress& progress);

/// `0:07`, `1:02:03`.
std::string durationText(double seconds);

/// That line on standard error, where that is a terminal; else nothing. Redrawn ten times a second at most,
/// wiped away at its end.
class SweepProgressLine
{
public:
  SweepProgressLine();
  ~SweepProgressLine();
  SweepProgressLine(const SweepProgressLine&) = delete;
  SweepProgressLine& operator=(const SweepProgressLine&) = delete;

  void show(const SweepProgress& progress);

private:
  bool visible_;
  std::chrono::steady_clock::time_point next_;
};

}  // namespace ratchet_sieve
