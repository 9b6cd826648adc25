#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace ratchet_sieve
{

/// "too slow: 19.96 times real time instead of 20", with enough digits to show the difference.
/// @param achieved less than @param asked, real-time factors
std::string tooSlowText(double achieved, double asked);

/// Measures the achieved real-time factor while a run is under way, and reports when it stays below the
/// requested one. Steps of a paused run and jumps of time are not counted.
class SpeedWatch
{
public:
  using Clock = std::chrono::steady_clock;

  /// To be called in every iteration of the node's loop.
  /// @param under_way whether the run has advanced unpaused since the last call
  /// @param time simulated [s] @param lost total wall time lost, from Pacer [s]
  void update(bool under_way, double time, double lost, Clock::time_point now);

  /// Restarts the measurement: the requested factor has changed.
  void forget();

  /// Simulated over wall time in the last full period; nothing before the end of the first.
  std::optional<double> achieved() const { return achieved_; }

  /// Whether wall time was lost in the last full period, the period of achieved().
  bool behind() const { return behind_; }

  /// A line for the log when the run falls behind, repeated at intervals while it does, and once when it
  /// keeps up again; nothing otherwise. @param asked the requested real-time factor
  struct Line
  {
    bool warning = false;
    std::string text;
  };
  std::optional<Line> line(double asked, Clock::time_point now);

  /// Measuring period, in wall time under way [s].
  static constexpr double PERIOD = 1.0;

  /// Interval at which a line is repeated [s of wall time].
  static constexpr double BETWEEN_LINES = 10.0;

private:
  std::optional<Clock::time_point> last_update_;
  double last_time_ = 0.0;
  double wall_ = 0.0;       ///< of the present period [s]
  double simulated_ = 0.0;  ///< of the present period [s]
  std::optional<double> achieved_;
  double lost_ = 0.0;           ///< total at the last update
  double lost_at_start_ = 0.0;  ///< total at the start of the present period
  bool behind_ = false;
  bool said_ = false;  ///< that it is behind
  Clock::time_point last_line_;
};

}  // namespace ratchet_sieve
