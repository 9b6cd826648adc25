#include "state/trajectory_sums.h"

#include "state/system_state.h"

namespace ratchet_sieve
{

TrajectorySums::TrajectorySums(const SystemState& system) : system_(system), gravity_(system.scene().gravity)
{
}

void TrajectorySums::entered(const Disk& disk, double time)
{
  Trajectory trajectory;
  trajectory.entered_x = positionAt(disk, time, gravity_).x();
  trajectory.counted_x = trajectory.entered_x;
  trajectory.counted_from = system_.epoch().start + time;
  integrate(trajectory, disk, time, -1.0);
  trajectories_.push_back(trajectory);
}

void TrajectorySums::left(const Departure& departure)
{
  Trajectory& trajectory = trajectories_[departure.slot];
  integrate(trajectory, system_.disk(departure.slot), departure.time);
  trajectory.left_when = system_.epoch().start + departure.time;
}

void TrajectorySums::restart(double time)
{
  for (std::uint32_t slot = 0; slot < trajectories_.size(); ++slot)
  {
    Trajectory& trajectory = trajectories_[slot];
    trajectory.counted_from = Trajectory::NEVER;
    if (!system_.active(slot))
      continue;
    Trajectory since;
    const Disk& disk = system_.disk(slot);
    integrate(since, disk, time, -1.0);
    trajectory.translation = since.translation;
    trajectory.rotation = since.rotation;
    trajectory.counted_x = positionAt(disk, time, gravity_).x() + trajectory.offset;
    trajectory.counted_from = system_.epoch().start + time;
  }
}

void TrajectorySums::rebase(double length)
{
  for (const std::uint32_t slot : system_.slots(true))
    integrate(trajectories_[slot], system_.disk(slot), length);
}

}  // namespace ratchet_sieve
