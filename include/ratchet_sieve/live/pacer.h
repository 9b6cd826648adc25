#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "ratchet_sieve/recording/stride.h"

namespace ratchet_sieve
{

/// Keeps simulated time in step with wall time, and limits the length of one advance so that callbacks are
/// served often enough.
class Pacer
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param real_time_factor simulated over wall time; 0: as fast as possible
  explicit Pacer(double real_time_factor) : factor_(real_time_factor) {}

  /// Restarts the pacing: simulated time `elapsed` [s] corresponds to `now`.
  void anchor(double elapsed, Clock::time_point now);

  /// Sets another real-time factor from simulated time `elapsed` [s] on. An earlier delay is not caught up.
  void setFactor(double real_time_factor, double elapsed, Clock::time_point now);

  /// The requested simulated over wall time; 0: as fast as possible.
  double factor() const { return factor_; }

  /// The simulated time that may be reached now [s], at most one stride ahead. A delay longer than a moment
  /// is not caught up: the run continues at the requested factor, not faster.
  double allowed(double elapsed, Clock::time_point now);

  /// Wall time until simulated time `elapsed` is due, at most LONGEST_WAIT [s].
  double wait(double elapsed, Clock::time_point now) const;

  /// Total wall time by which the simulation has fallen behind without catching up [s].
  double lost() const { return lost_; }

  /// The longest advance that takes about LONGEST_WAIT of wall time [simulated s].
  double stride() const { return stride_.length(); }

  /// Updates the stride from an advance by `simulated` [s] that took `wall` [s].
  void advanced(double simulated, double wall) { stride_.learn(simulated, wall); }

  /// Callbacks are served at least this often [s of wall time].
  static constexpr double LONGEST_WAIT = 0.01;

private:
  double factor_;
  double anchor_elapsed_ = 0.0;
  Clock::time_point anchor_wall_ = Clock::now();
  Stride stride_{LONGEST_WAIT};
  double lost_ = 0.0;
};

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
  /// keeps up again, an interval later at least; nothing otherwise. @param asked the requested real-time
  /// factor
  struct Line
  {
    bool warning = false;
    std::string text;
  };
  std::optional<Line> line(double asked, Clock::time_point now);

  /// Measuring period, in wall time under way [s].
  static constexpr double PERIOD = 1.0;

  /// Interval between lines [s of wall time].
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
