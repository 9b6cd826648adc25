#include "ratchet_sieve/live/speed_watch.h"

#include <fmt/format.h>

namespace ratchet_sieve
{
namespace
{
constexpr int DIGITS = 3;
constexpr int MOST_DIGITS = 6;
}  // namespace

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
  if (!behind_)
  {
    said_ = false;
    return Line{false, fmt::format("keeps up again: {:.3g} times real time", *achieved_)};
  }
  if (said_ && now - last_line_ < std::chrono::duration<double>(BETWEEN_LINES))
    return std::nullopt;
  said_ = true;
  last_line_ = now;
  return Line{true, fmt::format("{}; {:.1f} s lost so far", tooSlowText(*achieved_, asked), lost_)};
}

}  // namespace ratchet_sieve
