#pragma once

#include <cstdint>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// A disk in free flight: its state at its own time, not at the simulation's (delayed states).
/// World frame; times are local to the engine's present epoch.
struct alignas(64) Disk
{
  double x = 0.0;      ///< [m]
  double y = 0.0;      ///< [m]
  double vx = 0.0;     ///< [m/s]
  double vy = 0.0;     ///< [m/s]
  double spin = 0.0;   ///< counter-clockwise [rad/s]
  double angle = 0.0;  ///< [rad]
  double time = 0.0;   ///< of this state [s]
  std::uint32_t species = 0;
  std::uint32_t flights = 0;  ///< counts changes of the trajectory, to tell stale predictions

  void archive(StateArchive& state) { state(x, y, vx, vy, spin, angle, time, species, flights); }
};

/// The disk `time` [s] later or earlier on the same parabola.
inline Disk flown(const Disk& disk, double time, double gravity)
{
  const double elapsed = time - disk.time;
  Disk later = disk;
  later.x += disk.vx * elapsed;
  later.y += (disk.vy - 0.5 * gravity * elapsed) * elapsed;
  later.vy -= gravity * elapsed;
  later.angle += disk.spin * elapsed;
  later.time = time;
  return later;
}

}  // namespace ratchet_sieve
