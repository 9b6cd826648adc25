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

void forEachDiskState(const MachineState& machine, double time,
                      const std::function<void(const DiskState&)>& visit)
{
  const FrameOfBase base = machine.motion().at(time);
  const double width = machine.shape().width();
  // While the base turns all disks are between its ends, because they are wrapped when they pass an end.
  const bool wrapped = machine.scene().boundary != Boundary::PERIODIC || machine.motion().turning();
  for (std::uint32_t slot = 0; slot < machine.disks().size(); ++slot)
  {
    if (!machine.active(slot))
      continue;
    const Disk disk = flown(machine.disk(slot), time, machine.scene().gravity);
    const double s = base.into(Eigen::Vector2d(disk.position.x(), disk.position.y()) - base.displacement).x();
    const Image image = wrapped ? Image() : machine.image(-wholeWidths(s, 1.0 / width), time);
    DiskState state;
    state.id = machine.id(slot);
    state.species = disk.species;
    state.displacement = machine.passages().displacement(slot, disk.position.x());
    state.x = disk.position.x() + image.shift.x();
    state.y = disk.position.y() + image.shift.y();
    state.vx = disk.velocity.x() + image.velocity.x();
    state.vy = disk.velocity.y() + image.velocity.y();
    state.angle = wrappedAngle(disk.angle);
    state.spin = disk.spin;
    visit(state);
  }
}

}  // namespace ratchet_sieve
