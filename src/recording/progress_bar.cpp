#include "ratchet_sieve/recording/progress_bar.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "ratchet_sieve/recording/certainty.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{
namespace
{

constexpr auto REDRAW_INTERVAL = std::chrono::milliseconds(100);
constexpr std::size_t BAR_WIDTH = 24;      ///< [characters]
constexpr std::size_t USUAL_COLUMNS = 80;  ///< of a terminal that does not say how many it has

/// Longest line that the terminal on standard error shows without a break, after which a redrawn line would
/// stay [characters].
std::size_t lineWidth()
{
  winsize size = {};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return (known ? size.ws_col : USUAL_COLUMNS) - 1;
}

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

std::string progressText(double time, double duration, const Progress& progress, std::size_t width)
{
  const double done = duration > 0.0 ? std::min(time / duration, 1.0) : 1.0;
  std::string text = fmt::format(" {:5.1f} %  {:.2f} of {:g} s simulated", 100.0 * done, time, duration);
  if (progress.wall > 0.0)
    text += fmt::format("  {:.2f} M events/s", 1e-6 * static_cast<double>(progress.events) / progress.wall);
  if (progress.simulated > 0.0 && done < 1.0)
    text += fmt::format("  {} to go", durationText(progress.wall * (duration - time) / progress.simulated));
  if (progress.certainty_ratio)
    text += fmt::format("  error {:.2g} x the requested one", *progress.certainty_ratio);
  const std::size_t bar = std::min(BAR_WIDTH, width - std::min(width, text.size() + 2));
  const auto filled = static_cast<std::size_t>(done * static_cast<double>(bar));
  return '[' + std::string(filled, '#') + std::string(bar - filled, '.') + ']' + text;
}

ProgressBar::ProgressBar() : visible_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar()
{
  if (visible_)
    draw("");
}

bool ProgressBar::isDue()
{
  const auto now = Clock::now();
  if (!visible_ || now < next_)
    return false;
  next_ = now + REDRAW_INTERVAL;
  return true;
}

void ProgressBar::draw(const std::string& line) const
{
  fmt::print(stderr, "\r{}\x1b[K", line.substr(0, lineWidth()));
  std::fflush(stderr);
}

void ProgressBar::show(const std::string& line)
{
  if (isDue())
    draw(line);
}

void ProgressBar::show(std::size_t poured, std::size_t of)
{
  if (isDue() && poured > 0)
    draw(fmt::format("{} of {} poured", poured, countText(of, "disk")));
}

void ProgressBar::show(const Simulation& simulation)
{
  if (!start_time_)
  {
    start_time_ = simulation.time();
    start_events_ = simulation.events();
  }
  if (!isDue())
    return;
  const SceneDefinition& scene = simulation.scene();
  draw(progressText(simulation.time(), scene.duration,
                    {simulation.time() - *start_time_, simulation.events() - start_events_,
                     std::chrono::duration<double>(Clock::now() - start_).count(),
                     scene.accuracy.endsEarly() ? certaintyOf(simulation).ratio() : std::nullopt},
                    lineWidth()));
}

}  // namespace ratchet_sieve
