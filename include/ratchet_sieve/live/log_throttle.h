#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Limits the rate of log lines: passes the first at once, and then one in a period, the newest, with the
/// number of lines that it stands for. The last line of a burst is always logged.
class LogThrottle
{
public:
  using Clock = std::chrono::steady_clock;

  /// @return the line if it may be said now; it is kept otherwise, in place of what was kept before
  std::optional<std::string> put(const std::string& line, Clock::time_point now);

  /// @return what was kept, once its time has come
  std::optional<std::string> due(Clock::time_point now);

  static constexpr std::chrono::seconds PERIOD{1};  ///< of wall time

private:
  std::optional<Clock::time_point> last_said_;
  std::string kept_;
  std::uint64_t kept_count_ = 0;  ///< lines that came since the last was said
};

}  // namespace ratchet_sieve
