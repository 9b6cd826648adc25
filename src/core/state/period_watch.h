#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/observation.h"
#include "state/machine_state.h"

namespace ratchet_sieve
{

/// Granular temperature of each species at a time local to the epoch [J]; see
/// Simulation::granularTemperatures().
std::vector<std::optional<double>> granularTemperatures(const MachineState& machine, double time);

/// Averages over whole periods of the drive what swings with it. A sample now and then would show the beat of
/// its own rate with the drive's (aliasing): so every period is sampled, at fixed phases.
/// Periods begin where the drive has the phase that it had at the start of the run, so that they do not
/// depend on when the watch began. Times are local to the epoch unless said otherwise.
class PeriodWatch
{
public:
  /// Instants in a period: in the layer of Fig. 8 their mean is within 1 % of that of a thousand.
  static constexpr int PARTS = 8;

  /// Of faster drives one period in so long is sampled [s].
  static constexpr double LEAST_SPACING = 0.02;

  /// Both outlive this. @param collisions that the machine's run has counted
  PeriodWatch(const MachineState& machine, const CollisionCounts& collisions);

  void observe(PeriodObserver observer, double now);

  /// A period that was interrupted because the drive came to stand still counts for nothing.
  void motionChanged(double now);

  /// The next sample; nothing without an observer or where the drive stands still.
  std::optional<double> next() const;

  /// Samples all disks. @pre next() has come
  void sample(double now);

  void rebase(double length) { from_ -= length; }

private:
  void awaitPeriod(double from);
  void begin(double now);
  void addTemperatures(double now);

  const MachineState& machine_;
  const CollisionCounts& counted_;
  PeriodObserver observer_;
  double origin_;  ///< phase over 2 pi at which periods begin
  bool swings_ = false;
  double from_ = 0.0;           ///< what is awaited comes no earlier
  int part_ = 0;                ///< of the period, whose end is awaited; 0: its beginning
  double begun_ = 0.0;          ///< when it began, in the run's time [s]
  CollisionCounts collisions_;  ///< until then
  std::vector<TemperatureSum> temperatures_;
};

}  // namespace ratchet_sieve
