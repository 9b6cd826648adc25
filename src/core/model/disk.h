#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "model/motion.h"
#include "model/processor.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Position (x, y) and velocity (vx, vy) of a disk at a time. Side by side in registers, because they are
/// evaluated very often: Eigen's vectors take 5 % more instructions (Fig. 8).
struct Kinematics
{
  Two position;  ///< [m]
  Two velocity;  ///< [m/s]
  double time;   ///< [s]
};

/// A disk in free flight. World frame; times are local to the engine's present epoch. It is at P + V t - g
/// t^2 / 2, whenever the flight began: P and V are its position and velocity at time 0, were it on this
/// flight then. So two disks are a straight line apart, dP + dV t. One cache line with all that a search
/// reads; the rest is in DiskRecord.
struct alignas(64) Disk
{
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< P; where it left once it has left [m]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< V [m/s]
  double spin = 0.0;                                   ///< counter-clockwise [rad/s]
  double radius = 0.0;                                 ///< [m]
  std::array<float, 2> lost{};                         ///< what P has lost to rounding, see redirect() [m]
  std::uint32_t species = 0;
  std::uint32_t event_count = 0;  ///< counts changes of the flight, to detect stale predictions

  /// Moves the disk by `way` and adds `push` to its velocity, at `time`.
  ///
  /// In an inelastic collapse contacts follow one another before the disk has moved by one resolution of its
  /// position. If each rounded P anew, the disk would stand still or run ahead while its partner moves on. So
  /// what is lost by one is made good by the next.
  void redirect(Two way, Two push, double time)
  {
    const Two before = twoOf(velocity);
    const Two after = before + push;
    const Two from = twoOf(position);
    const Two change = way + Two{lost[0], lost[1]} - (after - before) * time;
    const Two to = from + change;
    const Two rest = (from - to) + change;
    lost = {static_cast<float>(rest[0]), static_cast<float>(rest[1])};
    store(to, position);
    store(after, velocity);
    countEvent();
  }

  /// Another thread may read the count meanwhile, to see that it is not the one of its prediction.
  void countEvent() { __atomic_store_n(&event_count, event_count + 1, __ATOMIC_RELAXED); }
  std::uint32_t eventCount() const { return __atomic_load_n(&event_count, __ATOMIC_RELAXED); }

  void archive(StateArchive& state) { state(position, velocity, spin, radius, lost, species, event_count); }
};

/// Position and velocity at `time`. The only place where this is computed, so that all callers get the same
/// bits.
inline Kinematics kinematicsAt(const Disk& disk, double time, double gravity)
{
  const Two fall{0.0, gravity * time};
  const Two velocity = twoOf(disk.velocity);
  return {positionAfter(twoOf(disk.position), velocity, fall, time), velocityAfter(velocity, fall), time};
}

inline Eigen::Vector2d positionAt(const Disk& disk, double time, double gravity)
{
  return vectorOf(kinematicsAt(disk, time, gravity).position);
}

/// Counts the disk's time from `zero` on.
inline void moveZero(Disk& disk, double zero, double gravity)
{
  const Kinematics then = kinematicsAt(disk, zero, gravity);
  store(then.position, disk.position);
  store(then.velocity, disk.velocity);
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
