#include "state/tally.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ratchet_sieve
{

void Tally::forget(const MachineState& machine, const std::vector<std::uint32_t>& left)
{
  for (const std::uint32_t slot : left)
    addLeft(machine, slot, gone_);
}

void Tally::restart()
{
  std::fill(gone_.begin(), gone_.end(), Sums());
  std::fill(at_block_end_.begin(), at_block_end_.end(), Sums());
  std::fill(blocks_.begin(), blocks_.end(), BlockAverages());
  std::fill(contacts_.begin(), contacts_.end(), 0);
}

void Tally::Sums::add(const Passage& passage, const Weights& weights, double x, double until)
{
  const double dx = x + passage.offset - passage.counted_x;
  const double dt = until - passage.counted_from;
  disks += 1.0;
  displacement += dx;
  time += dt;
  displacement_squared += dx * dx;
  displacement_time += dx * dt;
  time_squared += dt * dt;
  translation += weights.mass * passage.translation;
  rotation += weights.inertia * passage.rotation;
}

SpeciesMeans Tally::Sums::means(const SpeciesDefinition& species) const
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

Tally::Weights Tally::weights(const MachineState& machine, std::uint32_t slot)
{
  const Disk& disk = machine.disk(slot);
  const SpeciesDefinition& species = machine.scene().species[disk.species];
  const double mass = machine.grain(slot).mass;
  return {mass / species.mass, species.inertiaOf(mass, disk.radius) / species.inertia()};
}

std::vector<Tally::Sums> Tally::sums(const MachineState& machine, double time) const
{
  std::vector<Sums> sums = gone_;
  const double gravity = machine.scene().gravity;
  for (std::uint32_t slot = 0; slot < machine.disks().size(); ++slot)
  {
    const Disk& disk = machine.disk(slot);
    if (!machine.active(slot))
      addLeft(machine, slot, sums);
    else
      sums[disk.species].add(machine.passages().until(slot, disk, time), weights(machine, slot),
                             flown(disk, time, gravity).position.x(), machine.epoch().start + time);
  }
  return sums;
}

void Tally::addLeft(const MachineState& machine, std::uint32_t slot, std::vector<Sums>& sums)
{
  const Passage& passage = machine.passages()[slot];
  const Disk& disk = machine.disk(slot);
  if (passage.counts())
    sums[disk.species].add(passage, weights(machine, slot), disk.position.x(), passage.left_when);
}

void Tally::endBlock(const MachineState& machine, double time)
{
  std::vector<Sums> now = sums(machine, time);
  for (std::size_t s = 0; s < species_.size(); ++s)
    blocks_[s].add(now[s].displacement - at_block_end_[s].displacement, now[s].time - at_block_end_[s].time);
  at_block_end_ = std::move(now);
}

std::vector<SpeciesMeans> Tally::means(const MachineState& machine, double time) const
{
  const std::vector<Sums> all = sums(machine, time);
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
