#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "ratchet_sieve/core/commanded_quantity.h"

namespace ratchet_sieve
{

/// The topic of a quantity's setpoints, in the sieve's namespace.
std::string setpointTopic(Quantity quantity);

/// The limits of one setpoint of a node.
struct Setpoint
{
  Quantity quantity = Quantity::INCLINATION;
  Interval limits;

  std::string name() const { return describe(quantity).name; }
  std::string unit() const { return describe(quantity).unit; }

  /// The reason why the value is refused, with the limits; nothing if the value is finite and within the
  /// limits.
  std::optional<std::string> refusal(double value) const;
};

/// The default limits of a node, in the order of Quantity.
std::array<Setpoint, QUANTITIES> usualSetpoints();

/// Accepted setpoints that wait to be applied: the newest of each quantity. Each command requires new
/// predictions for all disks, so a thousand commands per second could take all computing time. Commands
/// therefore get a limited share of the time. While they wait, a newer setpoint replaces an older one.
class SetpointInbox
{
public:
  using Clock = std::chrono::steady_clock;

  void put(Quantity quantity, double value) { newest_[quantity] = value; }

  /// Applies the waiting setpoints if they are due. @param wait false: at once, because no run is under way
  void deliver(bool wait, const std::function<void(Quantity, double)>& command,
               const std::function<Clock::time_point()>& wall_clock = Clock::now);

  /// Largest share of wall time for commands.
  static constexpr double SHARE = 0.1;

private:
  std::map<Quantity, double> newest_;
  Clock::time_point next_;  ///< not before
};

/// Limits the rate of log lines. The first line passes at once. Then one line passes per period: the newest,
/// with the number of lines that it replaces. The last line of a burst is always logged.
class LogThrottle
{
public:
  using Clock = std::chrono::steady_clock;

  /// @return the line if it may be logged now; otherwise it is kept and replaces the line kept before
  std::optional<std::string> put(const std::string& line, Clock::time_point now);

  /// @return the kept line, once the period is over
  std::optional<std::string> due(Clock::time_point now);

  static constexpr std::chrono::seconds PERIOD{1};  ///< of wall time

private:
  std::optional<Clock::time_point> last_said_;
  std::string kept_;
  std::uint64_t kept_count_ = 0;  ///< lines since the last one that was logged
};

}  // namespace ratchet_sieve
