#include "ratchet_sieve/live/setpoint_inbox.h"

#include <algorithm>

namespace ratchet_sieve
{

void SetpointInbox::deliver(bool wait, const std::function<void(Quantity, double)>& command,
                            const std::function<Clock::time_point()>& wall_clock)
{
  const bool empty =
      std::none_of(newest_.begin(), newest_.end(), [](const auto& value) { return value.has_value(); });
  if (empty)
    return;
  const auto begin = wall_clock();
  if (wait && begin < next_)
    return;
  const auto values = newest_;
  newest_ = {};
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    if (const auto& value = values[indexOf(q.quantity)])
      command(q.quantity, *value);
  const auto end = wall_clock();
  next_ = end + std::chrono::duration_cast<Clock::duration>((end - begin) * (1.0 / SHARE - 1.0));
}

}  // namespace ratchet_sieve
