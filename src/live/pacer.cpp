#include "ratchet_sieve/live/pacer.h"

#include <algorithm>

#include <fmt/format.h>

namespace ratchet_sieve
{
namespace
{
/// A simulation that lags wall time by more than this [s] continues from its present time.
constexpr double TOLERATED_LAG = 0.1;

double seconds(Pacer::Clock::duration duration)
{
  return std::chrono::duration<double>(duration).count();
}

/// Of a speed in a warning: so many that it differs from the one asked for.
constexpr int DIGITS = 3;
constexpr int MOST_DIGITS = 6;
}  // namespace

void Pacer::anchor(double elapsed, Clock::time_point now)
{
  anchor_elapsed_ = elapsed;
  anchor_wall_ = now;
}

void Pacer::setFactor(double real_time_factor, double elapsed, Clock::time_point now)
{
  factor_ = real_time_factor;
  anchor(elapsed, now);
}

double Pacer::allowed(double elapsed, Clock::time_point now)
{
  const double longest = elapsed + stride();
  if (factor_ <= 0.0)
    return longest;
  const double target = anchor_elapsed_ + factor_ * seconds(now - anchor_wall_);
  if (target - elapsed > factor_ * TOLERATED_LAG)
  {
    lost_ += (target - elapsed) / factor_;
    anchor(elapsed, now);
  }
  return std::min(target, longest);
}

double Pacer::wait(double elapsed, Clock::time_point now) const
{
  if (factor_ <= 0.0)
    return 0.0;
  const double due = (elapsed - anchor_elapsed_) / factor_ - seconds(now - anchor_wall_);
  return std::min(std::max(due, 0.0), LONGEST_WAIT);
}

std::string tooSlowText(double achieved, double asked)
{
  for (int digits = DIGITS; digits <= MOST_DIGITS; ++digits)
  {
    const std::string reached = fmt::format("{:.{}g}", achieved, digits);
    const std::string wanted = fmt::format("{:.{}g}", asked, digits);
    if (reached != wanted)
      return fmt::format("too slow: {} times real time instead of {}", reached, wanted);
  }
  return fmt::format("too slow: a little less than {:g} times real time", asked);
}

void SpeedWatch::update(bool under_way, double time, double lost, Clock::time_point now)
{
  // A jump back of time means that another run has begun.
  if (last_update_ && under_way && time >= last_time_)
  {
    wall_ += std::chrono::duration<double>(now - *last_update_).count();
    simulated_ += time - last_time_;
  }
  last_update_ = now;
  last_time_ = time;
  lost_ = lost;
  if (wall_ < PERIOD)
    return;
  achieved_ = simulated_ / wall_;
  behind_ = lost_ > lost_at_start_;
  lost_at_start_ = lost_;
  wall_ = simulated_ = 0.0;
}

void SpeedWatch::forget()
{
  wall_ = simulated_ = 0.0;
  achieved_.reset();
  lost_at_start_ = lost_;
  behind_ = said_ = false;
}

std::optional<SpeedWatch::Line> SpeedWatch::line(double asked, Clock::time_point now)
{
  if (!achieved_ || (!behind_ && !said_))
    return std::nullopt;
  if (said_ && now - last_line_ < std::chrono::duration<double>(BETWEEN_LINES))
    return std::nullopt;
  said_ = behind_;
  last_line_ = now;
  if (!behind_)
    return Line{false, fmt::format("keeps up again: {:.3g} times real time", *achieved_)};
  return Line{true, fmt::format("{}; {:.1f} s lost so far", tooSlowText(*achieved_, asked), lost_)};
}

}  // namespace ratchet_sieve
