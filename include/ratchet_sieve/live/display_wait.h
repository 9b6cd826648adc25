#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Delays the start of a run until a display has subscribed, or until a timeout. RViz, for example, takes
/// seconds to start.
class DisplayWait
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param patience timeout [s of wall time]; 0: no delay
  explicit DisplayWait(double patience) : patience_(patience) {}

  /// Whether the start is still delayed.
  bool waiting() const { return !over_ && patience_ > 0.0; }

  /// To be called in every iteration of the node's loop. @param watched whether a display has subscribed
  /// @return a line for the log at the begin and at the end of the delay; nothing otherwise
  std::optional<std::string> update(bool watched, Clock::time_point now);

private:
  double patience_;
  std::optional<Clock::time_point> begin_;
  bool over_ = false;
};

}  // namespace ratchet_sieve
