#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Holds the start of a run until a display, such as RViz, which takes seconds to start, has subscribed, or
/// until a timeout.
class DisplayWait
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param patience timeout [s of wall time]; 0: the run is not held
  explicit DisplayWait(double patience) : patience_(patience) {}

  /// Whether the run is to be held.
  bool waiting() const { return !over_ && patience_ > 0.0; }

  /// To be called at every iteration of the node's loop. @param watched whether a display has subscribed
  /// @return a line for the log where waiting begins and where it ends; nothing otherwise
  std::optional<std::string> update(bool watched, Clock::time_point now);

private:
  double patience_;
  std::optional<Clock::time_point> begin_;
  bool over_ = false;
};

}  // namespace ratchet_sieve
