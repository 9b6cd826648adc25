#include "state/species_averages.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ratchet_sieve
{

void SpeciesAverages::forget(const SystemState& system, const std::vector<std::uint32_t>& left)
{
  for (const std::uint32_t slot : left)
    addLeft(system, slot, gone_);
}

void SpeciesAverages::restart()
{
  std::fill(gone_.begin(), gone_.end(), Sums());
  std::fill(at_block_end_.begin(), at_block_end_.end(), Sums());
  std::fill(blocks_.begin(), blocks_.end(), BlockAverages());
  std::fill(contacts_.begin(), contacts_.end(), 0);
}

void SpeciesAverages::Sums::add(const Trajectory& trajectory, const Weights& weights, double x, double until)
{
  const double dx = x + trajectory.offset - trajectory.counted_x;
  const double dt = until - trajectory.counted_from;
  disks += 1.0;
  displacement += dx;
  time += dt;
  displacement_squared += dx * dx;
  displacement_time += dx * dt;
  time_squared += dt * dt;
  translation += weights.mass * trajectory.translation;
  rotation += weights.inertia * trajectory.rotation;
}

SpeciesMeans SpeciesAverages::Sums::means(const SpeciesDefinition& species) const
{
  SpeciesMeans means;
  if (time <= 0.0)
    return means;
  const double vx = displacement / time;
  means.mean_vx = vx;
  means.kinetic_translational = species.mass * translation / time;
  means.kinetic_rotational = species.inertia() * rotation / time;
  if (disks > 1.0)
  {
    // The error of a ratio estimator: the scatter of each disk's displacement about vx times its time.
    const double scatter = displacement_squared - 2.0 * vx * displacement_time + vx * vx * time_squared;
    means.mean_vx_stderr = std::sqrt(std::max(0.0, scatter) * disks / (disks - 1.0)) / time;
  }
  return means;
}

SpeciesAverages::Weights SpeciesAverages::weights(const SystemState& system, std::uint32_t slot)
{
  const Disk& disk = system.disk(slot);
  const SpeciesDefinition& species = system.scene().species[disk.species];
  const double mass = system.grain(slot).mass;
  return {mass / species.mass, species.inertiaOf(mass, disk.radius) / species.inertia()};
}

std::vector<SpeciesAverages::Sums> SpeciesAverages::sums(const SystemState& system, double time) const
{
  std::vector<Sums> sums = gone_;
  const double gravity = system.scene().gravity;
  for (std::uint32_t slot = 0; slot < system.disks().size(); ++slot)
  {
    const Disk& disk = system.disk(slot);
    if (!system.active(slot))
      addLeft(system, slot, sums);
    else
      sums[disk.species].add(system.trajectories().until(slot, disk, time), weights(system, slot),
                             flown(disk, time, gravity).position.x(), system.epoch().start + time);
  }
  return sums;
}

void SpeciesAverages::addLeft(const SystemState& system, std::uint32_t slot, std::vector<Sums>& sums)
{
  const Trajectory& trajectory = system.trajectories()[slot];
  const Disk& disk = system.disk(slot);
  if (trajectory.counts())
    sums[disk.species].add(trajectory, weights(system, slot), disk.position.x(), trajectory.left_when);
}

void SpeciesAverages::endBlock(const SystemState& system, double time)
{
  std::vector<Sums> now = sums(system, time);
  for (std::size_t s = 0; s < species_.size(); ++s)
    blocks_[s].add(now[s].displacement - at_block_end_[s].displacement, now[s].time - at_block_end_[s].time);
  at_block_end_ = std::move(now);
}

std::vector<SpeciesMeans> SpeciesAverages::means(const SystemState& system, double time) const
{
  const std::vector<Sums> all = sums(system, time);
  std::vector<SpeciesMeans> means;
  for (std::size_t s = 0; s < species_.size(); ++s)
  {
    means.push_back(all[s].means(species_[s]));
    if (all[s].time > 0.0)
      means[s].collision_rate = static_cast<double>(contacts_[s]) / all[s].time;
    // The larger one: from differences between disks, or from fluctuations of the whole layer in time.
    const auto over_time = blocks_[s].standardError();
    if (over_time && means[s].mean_vx)
      means[s].mean_vx_stderr = std::max(means[s].mean_vx_stderr.value_or(0.0), *over_time);
  }
  return means;
}

}  // namespace ratchet_sieve
