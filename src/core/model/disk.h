#pragma once

#include <cstdint>
#include <cstring>

#include <Eigen/Core>

#include "model/motion.h"
#include "model/processor.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// A disk in free flight. Its state is given at its own time, not at the simulation's (delayed states). World
/// frame; times are local to the engine's present epoch. One cache line with all that a search reads; the
/// rest is in DiskProperties and Trajectory.
struct alignas(64) Disk
{
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< [m/s]
  double spin = 0.0;                                   ///< counter-clockwise [rad/s]
  double radius = 0.0;                                 ///< [m]
  double time = 0.0;                                   ///< of this state [s]
  std::uint32_t species = 0;
  std::uint32_t event_count = 0;  ///< counts changes of the trajectory, to detect stale predictions

  /// Another thread may read the count meanwhile, to see that it is not the one of its prediction.
  void countEvent() { __atomic_store_n(&event_count, event_count + 1, __ATOMIC_RELAXED); }
  std::uint32_t eventCount() const { return __atomic_load_n(&event_count, __ATOMIC_RELAXED); }

  void archive(StateArchive& state) { state(position, velocity, spin, radius, time, species, event_count); }
};

/// Position (x, y) and velocity (vx, vy) of a disk. Side by side in registers, because the pair search
/// evaluates very many: Eigen's vectors take 5 % more instructions (Fig. 8).
struct Kinematics
{
  Two position;  ///< [m]
  Two velocity;  ///< [m/s]
};

/// Position and velocity at `time` on the disk's parabola. The only place where this is computed, so that all
/// callers get the same bits.
inline Kinematics kinematicsAt(const Disk& disk, double time, double gravity)
{
  const double elapsed = time - disk.time;
  const Two fall{0.0, gravity * elapsed};
  const Two velocity{disk.velocity.x(), disk.velocity.y()};
  return {positionAfter(Two{disk.position.x(), disk.position.y()}, velocity, fall, elapsed),
          velocityAfter(velocity, fall)};
}

/// The disk at another time on the same parabola.
inline Disk flown(const Disk& disk, double time, double gravity)
{
  const Kinematics kinematics = kinematicsAt(disk, time, gravity);
  Disk later = disk;
  // One store each, as wide as the later load: two stores of 8 bytes before a load of 16 bytes cause a
  // store-forwarding stall.
  std::memcpy(later.position.data(), &kinematics.position, sizeof kinematics.position);
  std::memcpy(later.velocity.data(), &kinematics.velocity, sizeof kinematics.velocity);
  later.time = time;
  return later;
}

/// The properties of one disk that never change, besides its species and its radius, which the searches read
/// in Disk.
struct DiskProperties
{
  double mass = 0.0;           ///< [kg]
  double spin_response = 0.0;  ///< change of spin by a unit impulse along the rim: r / I [1/(kg m)]

  void archive(StateArchive& state) { state(mass, spin_response); }
};

/// The properties of a disk of this species, mass [kg] and radius [m].
inline DiskProperties propertiesOf(const SpeciesDefinition& species, double mass, double radius)
{
  return {mass, radius / species.inertiaOf(mass, radius)};
}

/// Of the mass that the species gives a disk of this radius.
inline DiskProperties propertiesOf(const SpeciesDefinition& species, double radius)
{
  return propertiesOf(species, species.massOf(radius), radius);
}

}  // namespace ratchet_sieve
