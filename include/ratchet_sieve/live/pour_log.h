#pragma once

#include <chrono>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Progress lines for slow pours. The first line comes when a pour has lasted for one period.
class PourLog
{
public:
  using Clock = std::chrono::steady_clock;

  static constexpr std::chrono::seconds PERIOD{2};  ///< between lines [s of wall time]

  /// To be called with the arguments of a PourObserver.
  /// @return a line for the log if one is due
  std::optional<std::string> line(std::size_t poured, std::size_t of, Clock::time_point now);

private:
  std::size_t poured_ = std::numeric_limits<std::size_t>::max();
  Clock::time_point next_line_;
};

}  // namespace ratchet_sieve
