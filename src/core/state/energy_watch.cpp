#include "state/energy_watch.h"

#include <algorithm>
#include <cmath>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/resolution.h"
#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// A poured heap is higher than a settled one by less than this factor.
constexpr double POURED_TO_SETTLED = 2.0;

/// From the base's lowest point to the highest disk [m].
double highestPlace(const SceneDefinition& scene)
{
  const double narrowing = scene.base.width() / pouredWidth(scene);
  double height = scene.pour.drop_height + POURED_TO_SETTLED * settledLayer(scene) * narrowing;
  for (const InitialDisk& disk : scene.initial)
    height = std::max({height, std::abs(disk.x), std::abs(disk.y)});
  // For any inclination, the difference in height of the two ends is at most the width.
  return height + scene.base.width() + scene.base.highest() + scene.base.depth() +
         2.0 * driveBounds(scene.base).displacement;
}
}  // namespace

EnergyWatch::EnergyWatch(const SystemState& system)
    : system_(system),
      highest_(highestPlace(system.scene())),
      start_speed_(startSpeed(system.scene())),
      gravity_(system.scene().gravity)
{
}

void EnergyWatch::check(double time)
{
  // By the drive in any direction, and by the turning of its raised end.
  const double base_speed =
      system_.motion().speedBound() + std::abs(system_.motion().inclinationRate()) * system_.shape().width();
  fastest_base_ = std::max(fastest_base_, base_speed);
  const double bounce =
      std::sqrt(2.0 * gravity_ * highest_ + start_speed_ * start_speed_) + 2.0 * fastest_base_;
  const double scale = 0.5 * bounce * bounce;
  if (scale <= 0.0)
    return;
  const auto& species = system_.scene().species;
  for (std::uint32_t slot = 0; slot < system_.disks().size(); ++slot)
  {
    if (!system_.active(slot))
      continue;
    const Disk& disk = system_.disk(slot);
    const SpeciesDefinition& kind = species[disk.species];
    const Kinematics now = kinematicsAt(disk, time, gravity_);
    const double height = now.position[1];
    const double rim = disk.spin * disk.radius;
    const double energy = 0.5 * (vectorOf(now.velocity).squaredNorm() + kind.inertia_factor * rim * rim) +
                          gravity_ * std::max(0.0, height);
    const double scales = energy / scale;
    if (scales <= largest_)
      continue;
    largest_ = scales;
    if (scales > ALARM && !first_)
      first_ = LargeEnergy{system_.epoch().start + time, system_.properties(slot).mass * energy, height,
                           scales, system_.id(slot)};
  }
}

}  // namespace ratchet_sieve
