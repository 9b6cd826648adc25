#pragma once

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// Which parts of the model a run computes. A part that a scene does not need changes no result and only
/// costs time.
struct Plan
{
  bool pairs = true;   ///< disk-disk collisions: cell list, event queue, pair search
  bool steps = false;  ///< fixed integration steps for disks that collide with each other; may miss contacts:
                       ///< Method::STEPS
  bool spin = true;    ///< tangential impulses and rotation
  bool drive = true;   ///< a moving base: phase and sine at every evaluation
  bool orbit = false;  ///< the drive has a horizontal part or harmonics, or moves along the base's axes
  bool contact_times = true;  ///< the time of each disk's last contact, for t_c

  /// SIMD: several disks at a time (simd_batch.h), while the base is at its setpoints. Only for independent
  /// disks without contact times on a periodic sawtooth with a vertical sine drive. The contacts are the same
  /// but for rounding.
  bool simd = false;
};

/// The cheapest plan that gives the scene's results. A setpoint that starts or turns a standing base is
/// followed even if the plan has no `drive`: BaseMotion checks for that in each segment.
Plan planOf(const SceneDefinition& scene);

}  // namespace ratchet_sieve
