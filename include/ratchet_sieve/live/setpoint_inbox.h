#pragma once

#include <array>
#include <chrono>
#include <functional>
#include <optional>

#include "ratchet_sieve/live/setpoint.h"

namespace ratchet_sieve
{

/// Good setpoints on their way to the run: the newest of each quantity. After each command all disks are
/// predicted again, so that a thousand a second of them could take all of the time there is: they get a share
/// of it, and no more; while they wait the newest wins.
class SetpointInbox
{
public:
  using Clock = std::chrono::steady_clock;

  void put(Quantity quantity, double value) { newest_[indexOf(quantity)] = value; }

  /// Hands over what is there, if its time has come. @param wait false: at once, as nothing runs that could
  /// suffer
  void deliver(bool wait, const std::function<void(Quantity, double)>& command,
               const std::function<Clock::time_point()>& wall_clock = Clock::now);

  /// Of all wall time, at most for commands.
  static constexpr double SHARE = 0.1;

private:
  std::array<std::optional<double>, QUANTITIES> newest_;  ///< in the order of Quantity
  Clock::time_point next_;                                ///< not before
};

}  // namespace ratchet_sieve
