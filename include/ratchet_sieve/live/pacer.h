#pragma once

#include <chrono>

namespace ratchet_sieve
{

/// Keeps simulated time in step with wall time, and says how far to advance in one go so that the
/// loop comes round often enough for callbacks.
class Pacer
{
public:
  using Clock = std::chrono::steady_clock;

  /// @param real_time_factor simulated over wall time; 0: as fast as it goes
  explicit Pacer(double real_time_factor) : factor_(real_time_factor) {}

  /// Restarts: simulated time `elapsed` [s] is now.
  void anchor(double elapsed, Clock::time_point now);

  /// Another speed from now on, at simulated time `elapsed` [s]: nothing of before is made up for.
  void setFactor(double real_time_factor, double elapsed, Clock::time_point now);

  /// Simulated over wall time, as it is asked for; 0: as fast as it goes.
  double factor() const { return factor_; }

  /// How far simulated time may be by now [s], no more than one stride. What the simulation has fallen behind
  /// by more than a moment is not made up for: it then goes on at the requested speed, no faster.
  double allowed(double elapsed, Clock::time_point now);

  /// Wall time until simulated time `elapsed` is due, at most LONGEST_WAIT [s].
  double wait(double elapsed, Clock::time_point now) const;

  /// Wall time lost so far, as the simulation could not keep up [s].
  double lost() const { return lost_; }

  /// The longest advance that takes about LONGEST_WAIT of wall time [s of simulated time].
  double stride() const { return stride_; }

  /// Learns from an advance over `simulated` that took `wall` [s].
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
