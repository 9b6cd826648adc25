#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace ratchet_sieve
{

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
