#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/disk.h"
#include "model/prefetch.h"
#include "state/disk_ids.h"

namespace ratchet_sieve
{

/// One disk's stay in the system: the sums over its flights. Kept after the disk has left. One cache line.
struct alignas(64) Trajectory
{
  /// Value of counted_from for disks that had left before the counting began.
  static constexpr double NEVER = std::numeric_limits<double>::infinity();

  double entered_x = 0.0;     ///< [m]
  double offset = 0.0;        ///< unwraps x [m]
  double counted_x = 0.0;     ///< unwrapped x at the start of the counting [m]
  double counted_from = 0.0;  ///< [s]; or NEVER
  double translation = 0.0;   ///< integral of v^2 / 2 [m^2/s]
  double rotation = 0.0;      ///< integral of spin^2 / 2 [1/s]
  double left_when = 0.0;     ///< [s]
  double angle = 0.0;         ///< at the disk's own time [rad]

  /// Whether any part of it counts.
  bool counts() const { return counted_from < NEVER; }

  void archive(StateArchive& state)
  {
    state(entered_x, offset, counted_x, counted_from, translation, rotation, left_when, angle);
  }
};

/// Displacements, and kinetic energies integrated exactly along every flight. Summed per disk, so that the
/// bits do not depend on the calls of advanceTo(). Times are the run's (not local to an epoch) unless stated
/// otherwise.
class TrajectorySums
{
public:
  /// @param spin whether disks can spin; see Plan
  TrajectorySums(double gravity, bool spin) : gravity_(gravity), spin_(spin) {}

  std::size_t size() const { return trajectories_.size(); }
  const Trajectory& operator[](std::uint32_t slot) const { return trajectories_[slot]; }
  void prefetchTrajectory(std::uint32_t slot) const { prefetch(trajectories_[slot]); }
  void reserve(std::size_t count) { trajectories_.reserve(count); }
  void keep(const std::vector<std::uint32_t>& slots) { keepSlots(trajectories_, slots); }

  void entered(const Disk& disk, double time);
  void left(std::uint32_t slot, double time) { trajectories_[slot].left_when = time; }

  /// Adds the part of a disk's flight from its own time to `time`, both local.
  void flew(std::uint32_t slot, const Disk& disk, double time) { integrate(trajectories_[slot], disk, time); }

  /// The disk was moved by -dx in the world by a periodic boundary; the displacement is unchanged.
  void wrapped(std::uint32_t slot, double dx) { trajectories_[slot].offset += dx; }

  /// A disk's trajectory including its present flight up to a local time.
  Trajectory until(std::uint32_t slot, const Disk& disk, double local_time) const
  {
    Trajectory trajectory = trajectories_[slot];
    integrate(trajectory, disk, local_time);
    return trajectory;
  }

  /// The sums that grow with every flight, for SIMD batches.
  struct Flown
  {
    double offset;
    double translation;
    double rotation;
    double angle;
  };

  void setFlown(std::uint32_t slot, const Flown& flown)
  {
    Trajectory& trajectory = trajectories_[slot];
    trajectory.offset = flown.offset;
    trajectory.translation = flown.translation;
    trajectory.rotation = flown.rotation;
    trajectory.angle = flown.angle;
  }

  /// Forgets all counts: the end of `settle`.
  /// @param local_time `time` in the epoch of the disks' own times
  void restart(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active, double time,
               double local_time);

  /// Unwrapped path along world x since the disk entered [m].
  double displacement(std::uint32_t slot, double x) const
  {
    return x + trajectories_[slot].offset - trajectories_[slot].entered_x;
  }

  void archive(StateArchive& state) { state(trajectories_); }

private:
  void integrate(Trajectory& trajectory, const Disk& disk, double local_time) const;

  double gravity_;
  bool spin_;
  std::vector<Trajectory> trajectories_;  ///< per slot
};

}  // namespace ratchet_sieve
