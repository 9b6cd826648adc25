#include "ratchet_sieve/live/display_wait.h"

#include <fmt/format.h>

namespace ratchet_sieve
{

std::optional<std::string> DisplayWait::update(bool watched, Clock::time_point now)
{
  if (!waiting())
    return {};
  const bool first = !begin_;
  if (first)
    begin_ = now;
  const double waited = std::chrono::duration<double>(now - *begin_).count();
  over_ = watched || waited >= patience_;
  if (watched)
    return fmt::format("a display has subscribed after {:.1f} s: the wait is over", waited);
  if (over_)
    return fmt::format(
        "no subscriber to ~markers or ~cloud after {:g} s (~wait_for_display): the wait is over", patience_);
  if (first)
    return fmt::format("the run waits for a subscriber to ~markers or ~cloud, for at most {:g} s", patience_);
  return {};
}

}  // namespace ratchet_sieve
