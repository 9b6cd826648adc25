#include "ratchet_sieve/live/pour_log.h"

#include <utility>

#include <fmt/format.h>

#include "ratchet_sieve/core/count_text.h"

namespace ratchet_sieve
{

std::optional<std::string> PourLog::line(std::size_t poured, std::size_t of, Clock::time_point now)
{
  // The count grows during one pour; if it does not, a new pour has begun.
  if (poured <= std::exchange(poured_, poured))
    next_line_ = now + PERIOD;
  if (now < next_line_)
    return std::nullopt;
  next_line_ = now + PERIOD;
  return fmt::format("{} of {} poured", poured, countText(of, "disk"));
}

}  // namespace ratchet_sieve
