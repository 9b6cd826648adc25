#include "ratchet_sieve/live/log_throttle.h"

namespace ratchet_sieve
{

std::optional<std::string> LogThrottle::put(const std::string& line, Clock::time_point now)
{
  kept_ = line;
  ++kept_count_;
  return due(now);
}

std::optional<std::string> LogThrottle::due(Clock::time_point now)
{
  if (kept_count_ == 0 || (last_said_ && now - *last_said_ < PERIOD))
    return std::nullopt;
  last_said_ = now;
  std::string line = kept_;
  if (kept_count_ > 1)
    line += " (the last of " + std::to_string(kept_count_) + ")";
  kept_count_ = 0;
  return line;
}

}  // namespace ratchet_sieve
