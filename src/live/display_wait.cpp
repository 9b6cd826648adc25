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
    return fmt::format("the run may begin: it is watched, after {:.1f} s", waited);
  if (over_)
    return fmt::format(
        "nobody watches ~markers or ~cloud after {:g} s (~wait_for_display): the run may begin", patience_);
  if (first)
    return fmt::format("the run waits until ~markers or ~cloud is watched, for {:g} s at most", patience_);
  return {};
}

}  // namespace ratchet_sieve
