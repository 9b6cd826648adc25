#include "ratchet_sieve/sweep/sweep_progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace ratchet_sieve
{
namespace
{

constexpr auto REDRAW_INTERVAL = std::chrono::milliseconds(100);
constexpr const char* CLEAR_LINE = "\r\x1b[K";

}  // namespace

std::string durationText(double seconds)
{
  constexpr double DAY = 86400.0;
  if (seconds >= 1000 * DAY)
    return fmt::format("{:.3g} years", seconds / (365.25 * DAY));
  if (seconds >= 2 * DAY)
    return fmt::format("{:.0f} days", seconds / DAY);
  const long whole = std::lround(seconds);
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

std::string sweepProgressText(const SweepProgress& progress)
{
  const std::uint64_t finished = progress.done + progress.failed;
  std::string text =
      fmt::format("{} of {} done, {} running", progress.done, progress.cases, progress.running);
  if (progress.failed > 0)
    text += fmt::format(", {} failed", progress.failed);
  if (progress.warned > 0)
    text += fmt::format(", {} with warnings", progress.warned);
  if (progress.finished_here > 0 && progress.wall > 0.0)
  {
    const double rate = static_cast<double>(progress.finished_here) / progress.wall;
    text += fmt::format(
        "  {:.3g} cases/s  {} to go", rate,
        durationText(static_cast<double>(progress.cases - std::min(finished, progress.cases)) / rate));
  }
  if (progress.best)
    text += fmt::format("  best mean Q {:.3f}", progress.best->quality());
  if (progress.best && progress.best->error)
    text += fmt::format(" +- {:.3f}", *progress.best->error);
  return text;
}

SweepProgressLine::SweepProgressLine()
    : visible_(isatty(STDERR_FILENO) == 1), next_(std::chrono::steady_clock::now())
{
}

void SweepProgressLine::show(const SweepProgress& progress)
{
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || now < next_)
    return;
  next_ = now + REDRAW_INTERVAL;
  fmt::print(stderr, "\r{}\x1b[K", sweepProgressText(progress));
  std::fflush(stderr);
}

SweepProgressLine::~SweepProgressLine()
{
  if (visible_)
    std::fputs(CLEAR_LINE, stderr);
}

}  // namespace ratchet_sieve
