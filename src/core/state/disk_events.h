#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "model/base_shape.h"
#include "model/disk.h"
#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/luding_law.h"
#include "ratchet_sieve/core/results.h"

/// What happens to disks, as observers are told of it.
namespace ratchet_sieve
{

/// The outcome of an executed contact, for all observers.
struct ContactOutcome
{
  /// Value of j for the base.
  static constexpr std::uint32_t BASE = UINT32_MAX;

  double time = 0.0;  ///< local to the epoch [s]
  CollisionKind kind = CollisionKind::APEX;
  BaseFeature feature;                ///< of the base; none between two disks, and from SIMD batches
  std::uint32_t i = 0;                ///< slot of the disk
  std::uint32_t j = BASE;             ///< slot of the second disk
  std::uint32_t species = 0;          ///< of disk i
  std::uint32_t partner_species = 0;  ///< of disk j
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< unit normal from j to i, world frame
  double normal_velocity = 0.0;     ///< of the surfaces, < 0: approaching; 0 if they separate [m/s]
  double normal_impulse = 0.0;      ///< J_n >= 0, along the normal on i [N s]
  double tangential_impulse = 0.0;  ///< J_t, along the tangent (normal turned by +90 deg) on i [N s]
  double overlap = 0.0;             ///< at the contact, < 0 for a remaining gap [m]
  bool closed = false;              ///< whether the surfaces approached; otherwise nothing was changed
  bool lossless = false;            ///< whether it was lossless: within t_c, or because of a collapse
};

/// The impulse on disk i, world frame [N s].
inline Eigen::Vector2d impulseOf(const ContactOutcome& outcome)
{
  const auto push = pushOf<double>({outcome.normal_impulse, outcome.tangential_impulse}, outcome.normal.x(),
                                   outcome.normal.y());
  return {push.x, push.y};
}

/// A disk's flight, which ends or changes. Its last one ended where it began, or the disk entered then. Times
/// are local to the epoch.
struct Flight
{
  std::uint32_t slot;
  Disk disk;   ///< as it flew
  double end;  ///< [s]
};

/// A disk has left the system. Its last flight was observed before.
struct Departure
{
  std::uint32_t slot;
  std::uint32_t species;
  double mass;  ///< [kg]
  Exit exit;
  double time;  ///< local to the epoch [s]
};

}  // namespace ratchet_sieve
