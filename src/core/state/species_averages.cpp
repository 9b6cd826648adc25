#include "state/species_averages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "state/system_state.h"

namespace ratchet_sieve
{

SpeciesAverages::SpeciesAverages(const SystemState& system) : system_(system)
{
  for (std::size_t s = 0; s < system.scene().species.size(); ++s)
    species_of_.push_back(s);
  for (const SizeClass& size_class : system.sizeClasses())
    species_of_.push_back(size_class.species);
  gone_.resize(species_of_.size());
  at_block_end_.resize(species_of_.size());
  blocks_.resize(species_of_.size());
}

void SpeciesAverages::add(std::uint32_t slot, const Trajectory& trajectory, double x, double until,
                          std::vector<Sums>& sums) const
{
  const Disk& disk = system_.disk(slot);
  const Weights disk_weights = weights(slot);
  sums[disk.species].add(trajectory, disk_weights, x, until);
  const std::size_t group = system_.scene().species.size() + system_.sizeClassOf(disk);
  if (group < sums.size())
    sums[group].add(trajectory, disk_weights, x, until);
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
      add(slot, system_.observers().trajectories().until(slot, disk, time),
          flown(disk, time, gravity).position.x(), system_.epoch().start + time, sums);
  }
  return sums;
}

void SpeciesAverages::addLeft(std::uint32_t slot, std::vector<Sums>& sums) const
{
  const Trajectory& trajectory = system_.observers().trajectories()[slot];
  if (trajectory.counts())
    add(slot, trajectory, system_.disk(slot).position.x(), trajectory.left_when, sums);
}

void SpeciesAverages::endBlock(double time)
{
  if (!system_.plan().pairs)
    return;
  std::vector<Sums> now = sums(time);
  for (std::size_t s = 0; s < blocks_.size(); ++s)
    blocks_[s].add(now[s].displacement - at_block_end_[s].displacement, now[s].time - at_block_end_[s].time);
  at_block_end_ = std::move(now);
}

std::vector<SpeciesMeans> SpeciesAverages::means(double time) const
{
  const SpeciesContacts& contacts = system_.observers().speciesContacts();
  const std::vector<Sums> all = sums(time);
  std::vector<SpeciesMeans> means;
  for (std::size_t s = 0; s < system_.scene().species.size(); ++s)
  {
    means.push_back(meansOf(s, all));
    if (all[s].time > 0.0)
      means[s].collision_rate = static_cast<double>(contacts.of(s)) / all[s].time;
  }
  return means;
}

std::vector<SpeciesMeans> SpeciesAverages::sizeClassMeans(double time) const
{
  const std::vector<Sums> all = sums(time);
  std::vector<SpeciesMeans> means;
  for (std::size_t group = system_.scene().species.size(); group < species_of_.size(); ++group)
    means.push_back(meansOf(group, all));
  return means;
}

SpeciesMeans SpeciesAverages::meansOf(std::size_t group, const std::vector<Sums>& sums) const
{
  SpeciesMeans means = sums[group].means(system_.scene().species[species_of_[group]]);
  if (!system_.plan().pairs || !means.mean_vx)
    return means;
  // The larger one: from differences between disks, or from fluctuations of the whole layer in time.
  const std::optional<double> over_time = blocks_[group].standardError();
  means.mean_vx_stderr =
      over_time ? std::optional(std::max(means.mean_vx_stderr.value_or(0.0), *over_time)) : std::nullopt;
  return means;
}

void SpeciesAverages::archive(StateArchive& state)
{
  state(gone_, at_block_end_, blocks_);
}

}  // namespace ratchet_sieve
