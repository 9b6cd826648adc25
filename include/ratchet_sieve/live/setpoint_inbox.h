#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <optional>

#include "ratchet_sieve/live/setpoint.h"

namespace ratchet_sieve
{

/// Accepted setpoints that wait to be applied: the newest of each quantity. Each command requires new
/// predictions for all disks, so a thousand commands per second could take all computing time. Commands
/// therefore get a limited share of the time. While they wait, a newer setpoint replaces an older one.
class SetpointInbox
{
public:
  using Clock = std::chrono::steady_clock;

  void put(Quantity quantity, double value) { newest_[indexOf(quantity)] = value; }

  /// Applies the waiting setpoints if they are due. @param wait false: at once, because no run is under way
  void deliver(bool wait, const std::function<void(Quantity, double)>& command,
               const std::function<Clock::time_point()>& wall_clock = Clock::now);

  /// Largest share of wall time for commands.
  static constexpr double SHARE = 0.1;

private:
  std::array<std::optional<double>, QUANTITIES> newest_;  ///< in the order of Quantity
  Clock::time_point next_;                                ///< not before
};

}  // namespace ratchet_sieve
