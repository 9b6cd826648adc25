#include "state/trajectory_sums.h"

#include "state/system_state.h"

namespace ratchet_sieve
{

TrajectorySums::TrajectorySums(const SystemState& system)
    : system_(system), gravity_(system.scene().gravity), spin_(system.plan().spin)
{
}

void TrajectorySums::entered(const Disk& disk)
{
  Trajectory trajectory;
  trajectory.entered_x = disk.position.x();
  trajectory.counted_x = disk.position.x();
  trajectory.counted_from = system_.epoch().start + disk.time;
  trajectories_.push_back(trajectory);
}

void TrajectorySums::left(const Departure& departure)
{
  trajectories_[departure.slot].left_when = system_.epoch().start + departure.time;
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

void TrajectorySums::restart(double time)
{
  for (std::uint32_t slot = 0; slot < trajectories_.size(); ++slot)
  {
    Trajectory& trajectory = trajectories_[slot];
    trajectory.counted_from = Trajectory::NEVER;
    if (!system_.active(slot))
      continue;
    // The part of the present flight before now is subtracted here, because it is added at the end of the
    // flight.
    Trajectory before;
    const Disk& disk = system_.disk(slot);
    integrate(before, disk, time);
    trajectory.translation = -before.translation;
    trajectory.rotation = -before.rotation;
    trajectory.counted_x = flown(disk, time, gravity_).position.x() + trajectory.offset;
    trajectory.counted_from = system_.epoch().start + time;
  }
}

}  // namespace ratchet_sieve
