#include "ratchet_sieve/core/plan.h"

#include <algorithm>

#include "model/orbit.h"
#include "ratchet_sieve/core/drive_of_scene.h"

namespace ratchet_sieve
{
namespace
{
/// beta = -1 leaves the tangential velocity unchanged for any friction: the disk is smooth.
bool turnsDisks(const ContactCoefficients& contact)
{
  return contact.friction > 0.0 && contact.tangential_restitution > -1.0;
}

/// Of all species, because disks of a species with none at the start may be poured later.
bool hasFriction(const SceneDefinition& scene)
{
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    if (turnsDisks(scene.species[i].contact))
      return true;
    for (std::size_t j = 0; scene.contact.pair_collisions && j < i; ++j)
      if (turnsDisks(contactBetween(scene, i, j)))
        return true;
  }
  return false;
}

bool startsWithSpin(const SceneDefinition& scene)
{
  return std::any_of(scene.initial.begin(), scene.initial.end(),
                     [](const InitialDisk& disk) { return disk.spin != 0.0; });
}
}  // namespace

Plan planOf(const SceneDefinition& scene)
{
  Plan plan;
  // Regardless of the number of disks: more may be poured at any time.
  plan.pairs = scene.contact.pair_collisions;
  plan.steps = plan.pairs && scene.accuracy.method == Method::STEPS;
  plan.spin = hasFriction(scene) || startsWithSpin(scene);
  plan.drive = hasStroke(scene.base) && scene.base.frequency > 0.0;
  plan.orbit = !Orbit(scene.base).empty() || scene.base.drive_frame == DriveFrame::BASE;
  plan.contact_times = scene.contact.contact_duration > 0.0;
  plan.simd = !plan.pairs && scene.boundary == Boundary::PERIODIC && !plan.contact_times && !plan.orbit &&
              scene.base.isSawtooth();
  return plan;
}

}  // namespace ratchet_sieve
