#include "ratchet_sieve/live/setpoint.h"

#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace ratchet_sieve
{

std::string setpointTopic(Quantity quantity)
{
  return describe(quantity).name + std::string("_setpoint");
}

std::optional<std::string> Setpoint::refusal(double value) const
{
  if (limits.contains(value))
    return std::nullopt;
  // Without the sign of a NaN, which has no meaning.
  return fmt::format("{} {:g} {} refused: must be from {:g} to {:g} {}", setpointTopic(quantity),
                     std::isnan(value) ? std::abs(value) : value, unit(), limits.min, limits.max, unit());
}

std::array<Setpoint, QUANTITIES> usualSetpoints()
{
  std::array<Setpoint, QUANTITIES> setpoints;
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    setpoints[indexOf(q.quantity)] = {q.quantity, q.usual};
  return setpoints;
}

void SetpointInbox::deliver(bool wait, const std::function<void(Quantity, double)>& command,
                            const std::function<Clock::time_point()>& wall_clock)
{
  if (newest_.empty())
    return;
  const auto begin = wall_clock();
  if (wait && begin < next_)
    return;
  for (const auto& [quantity, value] : std::exchange(newest_, {}))
    command(quantity, value);
  const auto end = wall_clock();
  next_ = end + std::chrono::duration_cast<Clock::duration>((end - begin) * (1.0 / SHARE - 1.0));
}

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
