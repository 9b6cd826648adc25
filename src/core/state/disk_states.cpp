#include "state/disk_states.h"

#include <cmath>
#include <cstdint>

namespace ratchet_sieve
{
namespace
{
constexpr double PI = 3.14159265358979323846;

double wrappedAngle(double angle)
{
  const double turns = angle / (2.0 * PI);
  return 2.0 * PI * (turns - std::floor(turns + 0.5));
}
}  // namespace

void forEachDiskState(const MachineState& machine, double time,
                      const std::function<void(const DiskState&)>& visit)
{
  const FrameOfBase base = machine.motion().at(time);
  const double width = machine.sawtooth().width();
  const bool periodic = machine.scene().boundary == Boundary::PERIODIC;
  for (std::uint32_t slot = 0; slot < machine.disks().size(); ++slot)
  {
    if (!machine.active(slot))
      continue;
    const Disk disk = flown(machine.disk(slot), time, machine.scene().gravity);
    const double s = base.into(Eigen::Vector2d(disk.position.x(), disk.position.y()) - base.displacement).x();
    const Image image = periodic ? machine.image(-wholeWidths(s, 1.0 / width), time) : Image();
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
