#include "state/species_averages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "state/system_state.h"

namespace ratchet_sieve
{

SpeciesAverages::SpeciesAverages(const SystemState& system)
    : system_(system),
      gone_(system.scene().species.size()),
      at_block_end_(gone_.size()),
      blocks_(gone_.size())
{
}

void SpeciesAverages::compact(const Compaction& compaction)
{
  for (const std::uint32_t slot : compaction.gone)
    addLeft(slot, gone_);
}

void SpeciesAverages::restart(double /*time*/)
{
  std::fill(gone_.begin(), gone_.end(), Sums());
  std::fill(at_block_end_.begin(), at_block_end_.end(), Sums());
  std::fill(blocks_.begin(), blocks_.end(), BlockAverages());
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

SpeciesAverages::Weights SpeciesAverages::weights(std::uint32_t slot) const
{
  const Disk& disk = system_.disk(slot);
  const SpeciesDefinition& species = system_.scene().species[disk.species];
  const double mass = system_.grain(slot).mass;
  return {mass / species.mass, species.inertiaOf(mass, disk.radius) / species.inertia()};
}

std::vector<SpeciesAverages::Sums> SpeciesAverages::sums(double time) const
{
  std::vector<Sums> sums = gone_;
  const double gravity = system_.scene().gravity;
  for (std::uint32_t slot = 0; slot < system_.disks().size(); ++slot)
  {
    const Disk& disk = system_.disk(slot);
    if (!system_.active(slot))
      addLeft(slot, sums);
    else
      sums[disk.species].add(system_.observers().trajectories().until(slot, disk, time), weights(slot),
                             flown(disk, time, gravity).position.x(), system_.epoch().start + time);
  }
  return sums;
}

void SpeciesAverages::addLeft(std::uint32_t slot, std::vector<Sums>& sums) const
{
  const Trajectory& trajectory = system_.observers().trajectories()[slot];
  const Disk& disk = system_.disk(slot);
  if (trajectory.counts())
    sums[disk.species].add(trajectory, weights(slot), disk.position.x(), trajectory.left_when);
}

void SpeciesAverages::endBlock(double time)
{
  if (!system_.plan().pairs)
    return;
  std::vector<Sums> now = sums(time);
  for (std::size_t s = 0; s < now.size(); ++s)
    blocks_[s].add(now[s].displacement - at_block_end_[s].displacement, now[s].time - at_block_end_[s].time);
  at_block_end_ = std::move(now);
}

std::vector<SpeciesMeans> SpeciesAverages::means(double time) const
{
  const std::vector<SpeciesDefinition>& species = system_.scene().species;
  const SpeciesContacts& contacts = system_.observers().speciesContacts();
  const std::vector<Sums> all = sums(time);
  std::vector<SpeciesMeans> means;
  for (std::size_t s = 0; s < all.size(); ++s)
  {
    means.push_back(all[s].means(species[s]));
    if (all[s].time > 0.0)
      means[s].collision_rate = static_cast<double>(contacts.of(s)) / all[s].time;
    // The larger one: from differences between disks, or from fluctuations of the whole layer in time.
    const auto over_time = blocks_[s].standardError();
    if (over_time && means[s].mean_vx)
      means[s].mean_vx_stderr = std::max(means[s].mean_vx_stderr.value_or(0.0), *over_time);
  }
  return means;
}

void SpeciesAverages::archive(StateArchive& state)
{
  const std::size_t species = gone_.size();
  state(gone_, at_block_end_, blocks_);
  state.require(gone_.size() == species && at_block_end_.size() == species && blocks_.size() == species,
                "its means have another number of species");
}

}  // namespace ratchet_sieve
