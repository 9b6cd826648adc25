#pragma once

#include <cstdint>

#include <Eigen/Core>

#include "ratchet_sieve/core/collision_counts.h"
#include "ratchet_sieve/core/luding_law.h"

namespace ratchet_sieve
{

/// The result of an executed contact: all that its observers receive.
struct ContactOutcome
{
  /// In place of a second disk: the base.
  static constexpr std::uint32_t BASE = UINT32_MAX;

  double time = 0.0;  ///< local to the epoch [s]
  CollisionKind kind = CollisionKind::APEX;
  std::uint32_t i = 0;                               ///< slot of the disk
  std::uint32_t j = BASE;                            ///< slot of the second disk
  int shift = 0;                                     ///< which image of j: so many widths to the right of it
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< unit normal, out of j on i, in the world
  double normal_velocity = 0.0;     ///< of the surfaces, < 0: approaching; 0 where they part [m/s]
  double normal_impulse = 0.0;      ///< J_n >= 0, along the normal on i [N s]
  double tangential_impulse = 0.0;  ///< J_t, along the tangent (normal turned by +90 deg) on i [N s]
  double overlap = 0.0;             ///< found at the contact, < 0 where a gap was left [m]
  bool closed = false;              ///< whether the surfaces approached: else nothing was done
  bool lossless = false;            ///< whether it was executed without loss: within t_c, or in a collapse
};

/// What disk i is given, in the world [N s].
inline Eigen::Vector2d impulseOf(const ContactOutcome& outcome)
{
  const auto push = pushOf<double>({outcome.normal_impulse, outcome.tangential_impulse}, outcome.normal.x(),
                                   outcome.normal.y());
  return {push.x, push.y};
}

}  // namespace ratchet_sieve
