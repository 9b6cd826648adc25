#pragma once

#include <cmath>
#include <cstdint>

#include "model/motion.h"
#include "ratchet_sieve/core/observation.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// In [-pi, pi) [rad].
inline double wrappedAngle(double angle)
{
  const double turns = angle / RADIANS_PER_TURN;
  return RADIANS_PER_TURN * (turns - std::floor(turns + 0.5));
}

/// Calls `visit` with the state of each active disk at a local time, one after the other, because an array of
/// all states would need as much memory as the engine itself.
template <typename Visit>
void forEachDiskState(const SystemState& system, double time, Visit&& visit)
{
  const FrameOfBase base = system.motion().at(time);
  const TrajectorySums& trajectories = system.observers().trajectories();
  // While the base turns all disks are between its ends, because they are wrapped when they pass an end.
  const bool wrapped = system.scene().boundary != Boundary::PERIODIC || system.motion().turning();
  const double gravity = system.scene().gravity;
  for (std::uint32_t slot = 0; slot < system.disks().size(); ++slot)
  {
    if (!system.active(slot))
      continue;
    const Disk& disk = system.disk(slot);
    const Kinematics now = kinematicsAt(disk, time, gravity);
    const Eigen::Vector2d position = vectorOf(now.position);
    const double widths = wrapped ? 0.0 : system.widthsOutside(base.positionInto(position).x());
    const Image image = widths == 0.0 ? Image() : system.image(-widths, time);
    DiskState state;
    state.id = system.id(slot);
    state.species = disk.species;
    state.radius = disk.radius;
    state.displacement = trajectories.displacement(slot, position.x());
    state.x = position.x() + image.shift.x();
    state.y = position.y() + image.shift.y();
    state.vx = now.velocity[0] + image.velocity.x();
    state.vy = now.velocity[1] + image.velocity.y();
    state.angle = wrappedAngle(trajectories.angle(slot, disk, time));
    state.spin = disk.spin;
    visit(state);
  }
}

}  // namespace ratchet_sieve
