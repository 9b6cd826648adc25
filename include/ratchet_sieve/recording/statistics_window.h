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

  double total() const { return disk_disk_rate + left_slope_rate + right_slope_rate + apex_rate + wall_rate; }
};

RATCHET_SIEVE_FIELDS(CollisionRates)
{
  RATCHET_SIEVE_FIELD(disk_disk_rate, "1/s");
  RATCHET_SIEVE_FIELD(left_slope_rate, "1/s");
  RATCHET_SIEVE_FIELD(right_slope_rate, "1/s");
  RATCHET_SIEVE_FIELD(apex_rate, "1/s");
  RATCHET_SIEVE_FIELD(wall_rate, "1/s");
}

/// What the statistics frames of one series are means over: the whole periods of the drive that ended since
/// the frame before. None ended: those of the frame before once more. Where the drive does not move the base,
/// there is nothing to average: the time since the frame before, and temperatures as they are.
class StatisticsWindow
{
public:
  /// One after the other, as Simulation::observePeriods() has them.
  void take(const PeriodRecord& period);

  /// Forgets what was taken: a window that is shown from now on begins at simulation.time() or later. To be
  /// called where periods were not observed for a while, so that no window spans the gap.
  void restart(const Simulation& simulation);

  /// To the frame at simulation.time(); at the same time once more it makes no difference.
  void moveTo(const Simulation& simulation);

  double start() const { return shown_.start; }  ///< [s]
  double end() const { return shown_.end; }      ///< [s]; start() before anything has gone by
  CollisionRates collisionRates() const;         ///< within the window; 0 where that is empty

  /// Per species [J]: half the mass times the variance of the velocity over the disks, mean over the window.
  /// Nothing where it had fewer than two disks, or no period has gone by.
  const std::vector<std::optional<double>>& granularTemperatures() const { return granular_temperatures_; }

private:
  void begin(double time, std::size_t species);

  std::optional<PeriodRecord> ended_;  ///< since the last frame, all as one
  PeriodRecord shown_;                 ///< what the last frame is of
  std::vector<std::optional<double>> granular_temperatures_;
  std::optional<double> last_time_;  ///< of a frame [s]
  CollisionCounts last_collisions_;
};

}  // namespace ratchet_sieve
