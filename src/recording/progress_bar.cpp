#include "ratchet_sieve/recording/progress_bar.h"

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
constexpr int BAR_WIDTH = 24;  ///< [characters]

std::string clockText(double seconds)
{
  const long whole = std::lround(std::min(seconds, 1e9));
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string progressText(double time, double duration, std::uint64_t events, double wall_seconds)
{
  const double done = duration > 0.0 ? std::min(time / duration, 1.0) : 1.0;
  const int filled = static_cast<int>(done * BAR_WIDTH);
  std::string text = fmt::format("[{}{}] {:5.1f} %  {:.2f} of {:g} s simulated", std::string(filled, '#'),
                                 std::string(BAR_WIDTH - filled, '.'), 100.0 * done, time, duration);
  if (wall_seconds > 0.0)
    text += fmt::format("  {:.2f} M events/s", 1e-6 * static_cast<double>(events) / wall_seconds);
  if (done > 0.0 && done < 1.0)
    text += fmt::format("  {} to go", clockText(wall_seconds * (1.0 - done) / done));
  return text;
}

ProgressBar::ProgressBar(double duration)
    : duration_(duration),
      visible_(isatty(STDERR_FILENO) == 1),
      start_(std::chrono::steady_clock::now()),
      next_(start_)
{
}

void ProgressBar::show(const Simulation& simulation)
{
  const auto now = std::chrono::steady_clock::now();
  if (!visible_ || now < next_)
    return;
  next_ = now + REDRAW_INTERVAL;
  const double wall_seconds = std::chrono::duration<double>(now - start_).count();
  fmt::print(stderr, "\r{}\x1b[K",
             progressText(simulation.time(), duration_, simulation.events(), wall_seconds));
  std::fflush(stderr);
}

ProgressBar::~ProgressBar()
{
  if (visible_)
    std::fputs("\r\x1b[K", stderr);
}

}  // namespace ratchet_sieve
