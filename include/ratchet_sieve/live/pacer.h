#pragma once

#include <chrono>

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
  double stride() const { return stride_; }

  /// Updates the stride from an advance by `simulated` [s] that took `wall` [s].
  void advanced(double simulated, double wall);

  /// Callbacks are served at least this often [s of wall time].
  static constexpr double LONGEST_WAIT = 0.01;

private:
  double factor_;
  double anchor_elapsed_ = 0.0;
  Clock::time_point anchor_wall_ = Clock::now();
  double stride_ = 1e-3;
  double lost_ = 0.0;
};

}  // namespace ratchet_sieve
