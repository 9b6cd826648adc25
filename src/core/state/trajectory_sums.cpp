#include "state/trajectory_sums.h"

namespace ratchet_sieve
{

void TrajectorySums::entered(const Disk& disk, double time)
{
  Trajectory trajectory;
  trajectory.entered_x = disk.position.x();
  trajectory.counted_x = disk.position.x();
  trajectory.counted_from = time;
  trajectories_.push_back(trajectory);
}

void TrajectorySums::integrate(Trajectory& trajectory, const Disk& disk, double local_time) const
{
  const double span = local_time - disk.time;
  const double fall = gravity_ * span;
  trajectory.translation += translationOver(disk.velocity.x(), disk.velocity.y(), fall, span);
  if (!spin_)
    return;
  trajectory.rotation += rotationOver(disk.spin, span);
  trajectory.angle = positionAfter(trajectory.angle, disk.spin, span);
}

void TrajectorySums::restart(const std::vector<Disk>& disks, const std::vector<std::uint8_t>& active,
                             double time, double local_time)
{
  for (std::uint32_t slot = 0; slot < disks.size(); ++slot)
  {
    Trajectory& trajectory = trajectories_[slot];
    trajectory.counted_from = Trajectory::NEVER;
    if (!active[slot])
      continue;
    // The part of the present flight before now is subtracted here, because it is added at the end of the
    // flight.
    Trajectory before;
    integrate(before, disks[slot], local_time);
    trajectory.translation = -before.translation;
    trajectory.rotation = -before.rotation;
    trajectory.counted_x = flown(disks[slot], local_time, gravity_).position.x() + trajectory.offset;
    trajectory.counted_from = time;
  }
}

}  // namespace ratchet_sieve
