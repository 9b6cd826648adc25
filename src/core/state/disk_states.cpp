#include "state/disk_states.h"

#include <cmath>
#include <cstdint>

#include "model/sine.h"

namespace ratchet_sieve
{
namespace
{
double wrappedAngle(double angle)
{
  const double turns = angle / RADIANS_PER_TURN;
  return RADIANS_PER_TURN * (turns - std::floor(turns + 0.5));
}
}  // namespace

void forEachDiskState(const SystemState& system, double time,
                      const std::function<void(const DiskState&)>& visit)
{
  const FrameOfBase base = system.motion().at(time);
  // While the base turns all disks are between its ends, because they are wrapped when they pass an end.
  const bool wrapped = system.scene().boundary != Boundary::PERIODIC || system.motion().turning();
  for (std::uint32_t slot = 0; slot < system.disks().size(); ++slot)
  {
    if (!system.active(slot))
      continue;
    const Disk disk = flown(system.disk(slot), time, system.scene().gravity);
    const double s = base.positionInto(disk.position).x();
    const Image image = wrapped ? Image() : system.image(-system.widthsOutside(s), time);
    DiskState state;
    state.id = system.id(slot);
    state.species = disk.species;
    state.radius = disk.radius;
    state.displacement = system.observers().trajectories().displacement(slot, disk.position.x());
    state.x = disk.position.x() + image.shift.x();
    state.y = disk.position.y() + image.shift.y();
    state.vx = disk.velocity.x() + image.velocity.x();
    state.vy = disk.velocity.y() + image.velocity.y();
    state.angle = wrappedAngle(system.observers().trajectories().until(slot, system.disk(slot), time).angle);
    state.spin = disk.spin;
    visit(state);
  }
}

}  // namespace ratchet_sieve
