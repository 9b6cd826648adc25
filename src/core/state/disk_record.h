#pragma once

#include <cstdint>
#include <limits>

#include <Eigen/Core>

#include "model/disk.h"
#include "model/slot_array.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The events of one disk in its present time window: see CollapseWatch.
struct CollapseWindow
{
  double end = 0.0;  ///< local to the epoch [s]
  std::uint32_t events = 0;
  std::uint32_t level = 0;  ///< consecutive collapses

  void archive(StateArchive& state) { state(end, events, level); }
};

/// What is kept of a disk besides its flight: its properties, and sums over its stay in the machine, which
/// include its present flight up to the epoch's zero, as if it were on it then. Kept after the disk has left.
/// Two cache lines; most events change the first alone. Times are the run's unless stated otherwise.
struct alignas(64) DiskRecord
{
  /// Value of counted_from of disks that do not count, or no longer: they had left before, or are closed.
  static constexpr double NEVER = std::numeric_limits<double>::infinity();

  DiskProperties properties;
  CollapseWindow window;
  double translation = 0.0;  ///< integral of v^2 / 2 [m^2/s]
  double rotation = 0.0;     ///< integral of spin^2 / 2 [1/s]
  double angle = 0.0;        ///< [rad]
  bool active = true;        ///< whether it is in the machine

  double last_contact =
      -std::numeric_limits<double>::infinity();  ///< local to the epoch, if the plan needs it [s]
  Eigen::Vector2d base_impulse =
      Eigen::Vector2d::Zero();  ///< from the base since the means began, world [N s]
  double entered_x = 0.0;       ///< [m]
  double offset = 0.0;          ///< unwraps x [m]
  double counted_x = 0.0;       ///< unwrapped x at the start of the counting [m]
  double counted_from = 0.0;    ///< [s]; or NEVER
  double left_when = 0.0;       ///< [s]

  /// Whether any part of its stay is to be added to the averages.
  bool counts() const { return counted_from < NEVER; }

  /// Unwrapped path along world x since the disk entered [m].
  double displacement(double x) const { return x + offset - entered_x; }

  /// At a local time of the disk's present flight [rad].
  double angleAt(const Disk& disk, double local_time) const
  {
    return positionAfter(angle, disk.spin, local_time);
  }

  /// Adds the disk's flight from the epoch's zero to a local time. @param sign -1.0: subtracts it
  void fly(const Disk& disk, double local_time, double gravity, double sign = 1.0)
  {
    const double span = sign * local_time;
    translation += translationOver(disk.velocity.x(), disk.velocity.y(), gravity * local_time, span);
    rotation += rotationOver(disk.spin, span);
    angle = positionAfter(angle, disk.spin, span);
  }

  /// The disk turns from a flight with this velocity and spin into its present one, at a local time.
  void turn(Two velocity, double spin, const Disk& disk, double local_time, double gravity)
  {
    translation += translationChange(velocity[0], velocity[1], disk.velocity.x(), disk.velocity.y(),
                                     gravity * local_time, local_time);
    rotation += rotationChange(spin, disk.spin, local_time);
    angle += (spin - disk.spin) * local_time;
  }

  /// The counting begins at a local time, `epoch_start` before the run's.
  void count(const Disk& disk, double local_time, double epoch_start, double gravity)
  {
    base_impulse.setZero();
    counted_from = active ? epoch_start + local_time : NEVER;
    if (!active)
      return;
    translation = -translationOver(disk.velocity.x(), disk.velocity.y(), gravity * local_time, local_time);
    rotation = -rotationOver(disk.spin, local_time);
    counted_x = positionAt(disk, local_time, gravity).x() + offset;
  }

  void archive(StateArchive& state)
  {
    state(properties, window, translation, rotation, angle, active, last_contact, base_impulse, entered_x,
          offset, counted_x, counted_from, left_when);
  }
};

}  // namespace ratchet_sieve
