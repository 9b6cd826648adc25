#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Holds the beginning of a run until somebody watches it, such as RViz, which takes seconds to come up; not
/// for ever.
class DisplayWait
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param patience for so long at most [s of wall time]; 0: nothing is waited for
  explicit DisplayWait(double patience) : patience_(patience) {}

  /// Whether the run is to be held.
  bool waiting() const { return !over_ && patience_ > 0.0; }

  /// To be told at every turn of the node's loop. @param watched whether somebody watches
  /// @return a line for the log where waiting begins and where it ends; nothing otherwise
  std::optional<std::string> look(bool watched, Clock::time_point now);

private:
  double patience_;
  std::optional<Clock::time_point> begin_;
  bool over_ = false;
};

}  // namespace ratchet_sieve
