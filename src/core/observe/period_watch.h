#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/core/results.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Granular temperature of each species at a time local to the epoch [J]; see
/// Simulation::granularTemperatures().
std::vector<std::optional<double>> granularTemperatures(const SystemState& system, double time);

/// Averages oscillating quantities over whole periods of the drive. Samples at a rate of their own would show
/// the beat with the drive (aliasing), so every period is sampled at fixed phases. Periods begin at the phase
/// that the drive had at the start of the run, so that they do not depend on the start of the observation.
/// Times are local to the epoch unless stated otherwise.
class PeriodWatch
{
public:
  /// Samples per period: in the layer of Fig. 8 their mean is within 1 % of that of a thousand.
  static constexpr int PARTS = 8;

  /// For faster drives, one period per this time is sampled [s].
  static constexpr double LEAST_SPACING = 0.02;

  /// @param system outlives this
  explicit PeriodWatch(const SystemState& system);

  void observe(PeriodObserver observer, double now);

  /// To be called when the motion changes: a period interrupted by a stop of the drive is discarded.
  void motionChanged(double now)
  {
    if (swings_ != system_.motion().swings())
      awaitPeriod(now);
    swings_ = system_.motion().swings();
  }

  /// The time of the next sample; nothing without an observer or while the drive stands still.
  std::optional<double> next() const;

  /// Samples all disks. @pre the time is next()
  void sample(double now);

  void rebase(double length) { from_ -= length; }

private:
  void awaitPeriod(double from)
  {
    from_ = from;
    part_ = 0;
  }
  void begin(double now);

  const SystemState& system_;
  PeriodObserver observer_;
  double origin_;  ///< phase over 2 pi at which periods begin
  bool swings_ = false;
  double from_ = 0.0;           ///< earliest time of the next sample
  int part_ = 0;                ///< the next sample ends this part of the period; 0: it begins the period
  double begun_ = 0.0;          ///< start of the period, in the run's time [s]
  CollisionCounts collisions_;  ///< until then
  std::vector<TemperatureSum> temperatures_;
};

}  // namespace ratchet_sieve
