#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// "too slow: 19.96 times real time instead of 20", with as many digits as are needed to see a difference.
/// @param achieved less than @param asked, real-time factors
std::string tooSlowText(double achieved, double asked);

/// Measures the achieved real-time factor while a run is under way, and reports when it stays below the
/// requested one. Steps of a paused run and jumps of time do not count.
class SpeedWatch
{
public:
  using Clock = std::chrono::steady_clock;

  /// To be called at every iteration of the node's loop.
  /// @param under_way whether the run has advanced by itself since the last call
  /// @param time simulated [s] @param lost wall time lost so far, as Pacer counts it [s]
  void update(bool under_way, double time, double lost, Clock::time_point now);

  /// Starts measuring again: the requested factor has changed.
  void forget();

  /// Simulated over wall time, over the last full period; nothing before that.
  std::optional<double> achieved() const { return achieved_; }

  /// Whether wall time was lost within the last full period: the one of which achieved() is.
  bool behind() const { return behind_; }

  /// A line for the log where it begins to fall behind, now and then while it does, and once when it no
  /// longer does; nothing otherwise. @param asked for, real-time factor
  struct Line
  {
    bool warning = false;
    std::string text;
  };
  std::optional<Line> line(double asked, Clock::time_point now);

  /// Over this much of wall time under way the speed is measured [s].
  static constexpr double PERIOD = 1.0;

  /// Between two lines of the log that say the same [s of wall time].
  static constexpr double BETWEEN_LINES = 10.0;

private:
  std::optional<Clock::time_point> last_update_;
  double last_time_ = 0.0;
  double wall_ = 0.0;       ///< of the present period [s]
  double simulated_ = 0.0;  ///< of the present period [s]
  std::optional<double> achieved_;
  double lost_ = 0.0;           ///< at the last update
  double lost_at_start_ = 0.0;  ///< of the present period
  bool behind_ = false;
  bool said_ = false;  ///< that it is behind
  Clock::time_point last_line_;
};

}  // namespace ratchet_sieve
