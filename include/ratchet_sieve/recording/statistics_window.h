#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// How often each kind of collision happens [1/s of simulated time].
struct CollisionRates
{
  double disk_disk_rate = 0.0;
  double left_slope_rate = 0.0;
  double right_slope_rate = 0.0;
  double apex_rate = 0.0;
  double wall_rate = 0.0;
  double level_rate = 0.0;

  double total() const
  {
    return disk_disk_rate + left_slope_rate + right_slope_rate + apex_rate + wall_rate + level_rate;
  }
};

RATCHET_SIEVE_FIELDS(CollisionRates)
{
  RATCHET_SIEVE_FIELD(disk_disk_rate, "1/s");
  RATCHET_SIEVE_FIELD(left_slope_rate, "1/s");
  RATCHET_SIEVE_FIELD(right_slope_rate, "1/s");
  RATCHET_SIEVE_FIELD(apex_rate, "1/s");
  RATCHET_SIEVE_FIELD(wall_rate, "1/s");
  RATCHET_SIEVE_FIELD(level_rate, "1/s");
}

/// The window over which the statistics frames of one series are averaged: the whole periods of the drive
/// that ended since the previous frame. If no period ended, the previous window is kept. If the drive does
/// not move the base, the window is the time since the previous frame, and temperatures are instantaneous.
class StatisticsWindow
{
public:
  /// @pre the periods are in the order of Simulation::observePeriods()
  void take(const PeriodRecord& period);

  /// Forgets all periods: the next window begins at simulation.time() or later. To be called after a gap in
  /// the observation of periods, so that no window spans the gap.
  void restart(const Simulation& simulation);

  /// Moves the window to the frame at simulation.time(). A second call at the same time does nothing.
  void moveTo(const Simulation& simulation);

  double start() const { return shown_.start; }  ///< [s]
  double end() const { return shown_.end; }      ///< [s]; equals start() before the first window
  CollisionRates collisionRates() const;         ///< within the window; 0 if it is empty

  /// Per species [J]: half the mass times the variance of the velocity over the disks, averaged over the
  /// window. Nothing if the species had fewer than two disks or no period has ended.
  const std::vector<std::optional<double>>& granularTemperatures() const { return granular_temperatures_; }

private:
  std::optional<PeriodRecord> ended_;  ///< all periods since the last frame, merged
  PeriodRecord shown_;                 ///< the window of the last frame
  std::vector<std::optional<double>> granular_temperatures_;
  std::optional<double> last_time_;  ///< of the last frame [s]
  CollisionCounts last_collisions_;
};

}  // namespace ratchet_sieve
