#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/processor.h"
#include "state/observer.h"

namespace ratchet_sieve
{

class SystemState;

/// One disk's stay in the machine: the sums over its flights, of the present one up to the epoch's zero, as
/// if the disk were on it then. Kept after the disk has left. One cache line.
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
  double angle = 0.0;         ///< [rad]

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
class TrajectorySums final : public Observer
{
public:
  explicit TrajectorySums(const SystemState& system);

  const Trajectory& operator[](std::uint32_t slot) const { return trajectories_[slot]; }
  Trajectory& operator[](std::uint32_t slot) { return trajectories_[slot]; }
  const std::vector<Trajectory>& all() const { return trajectories_; }
  void setAll(const std::vector<Trajectory>& trajectories) { trajectories_ = trajectories; }
  void reserve(std::size_t count) override { trajectories_.reserve(count); }
  void compact(const Compaction& compaction) override { keepSlots(trajectories_, compaction.kept); }

  void entered(const Disk& disk, double time) override;
  void left(const Departure& departure) override;

  /// A disk turns from a flight with this velocity and spin into its present one, at a local time.
  void turned(std::uint32_t slot, Two velocity, double spin, const Disk& disk, double time)
  {
    Trajectory& trajectory = trajectories_[slot];
    trajectory.translation += translationChange(velocity[0], velocity[1], disk.velocity.x(), disk.velocity.y(),
                                                gravity_ * time, time);
    trajectory.rotation += rotationChange(spin, disk.spin, time);
    trajectory.angle += (spin - disk.spin) * time;
  }

  /// The disk was moved by -dx in the world by a periodic boundary; the displacement is unchanged.
  void wrapped(std::uint32_t slot, double dx) { trajectories_[slot].offset += dx; }

  /// A disk's trajectory including its present flight up to a local time.
  Trajectory until(std::uint32_t slot, const Disk& disk, double local_time) const
  {
    Trajectory trajectory = trajectories_[slot];
    integrate(trajectory, disk, local_time);
    return trajectory;
  }

  /// At a local time of the disk's present flight [rad].
  double angle(std::uint32_t slot, const Disk& disk, double local_time) const
  {
    return positionAfter(trajectories_[slot].angle, disk.spin, local_time);
  }

  void restart(double time) override;
  void rebase(double length) override;

  /// Unwrapped path along world x since the disk entered [m].
  double displacement(std::uint32_t slot, double x) const
  {
    return x + trajectories_[slot].offset - trajectories_[slot].entered_x;
  }

  bool fits(std::size_t slots) const override { return trajectories_.size() == slots; }
  void archive(StateArchive& state) override { state(trajectories_); }

private:
  /// Adds the disk's flight from the epoch's zero to a local time. @param sign -1.0: subtracts it
  void integrate(Trajectory& trajectory, const Disk& disk, double local_time, double sign = 1.0) const
  {
    const double span = sign * local_time;
    trajectory.translation +=
        translationOver(disk.velocity.x(), disk.velocity.y(), gravity_ * local_time, span);
    trajectory.rotation += rotationOver(disk.spin, span);
    trajectory.angle = positionAfter(trajectory.angle, disk.spin, span);
  }

  const SystemState& system_;
  double gravity_;
  std::vector<Trajectory> trajectories_;  ///< per slot
};

}  // namespace ratchet_sieve
