#include "ratchet_sieve/live/pour_log.h"

#include <utility>

#include <fmt/format.h>

namespace ratchet_sieve
{

std::optional<std::string> PourLog::line(std::size_t poured, std::size_t of, Clock::time_point now)
{
  // The count grows within a pour: another pour has begun where it does not.
  if (poured <= std::exchange(poured_, poured))
    next_line_ = now + PERIOD;
  if (now < next_line_)
    return std::nullopt;
  next_line_ = now + PERIOD;
  return fmt::format("{} of {} disks poured", poured, of);
}

}  // namespace ratchet_sieve
