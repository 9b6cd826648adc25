#include "ratchet_sieve/live/certainty_log.h"

#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/recording/certainty.h"

namespace ratchet_sieve
{

std::optional<std::string> CertaintyLog::line(const Simulation& simulation)
{
  if (!simulation.scene().accuracy.endsEarly())
    return std::nullopt;
  if (simulation.startTime() != start_ || simulation.time() < last_time_)
    *this = {};
  start_ = simulation.startTime();
  last_time_ = simulation.time();
  if (said_ || (next_ && last_time_ < *next_))
    return std::nullopt;
  const bool due = std::exchange(next_, LookTimes(simulation).next()).has_value();
  if (!due || !*certaintyOf(simulation).reached())
    return std::nullopt;
  said_ = true;
  return fmt::format("at {:g} s the requested accuracy is reached; the run continues", last_time_);
}

}  // namespace ratchet_sieve
