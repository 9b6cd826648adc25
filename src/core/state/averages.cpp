#include "state/averages.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// Groups of a species: enough for a relative accuracy of 10 % of the error, few enough to store their
/// series.
constexpr std::size_t GROUPS = 64;

bool sameLengths(const std::vector<BlockAverages>& rows)
{
  return std::all_of(rows.begin(), rows.end(),
                     [&rows](const BlockAverages& row)
                     { return row.blocks().size() == rows.front().blocks().size(); });
}
}  // namespace

template <typename Sum>
void Averages::Series<Sum>::endBlock(std::vector<Sum>&& now)
{
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    const BlockSum& path = now[k];
    const BlockSum& before = at_block_end[k];
    blocks[k].add(path.sum - before.sum, path.weight - before.weight);
  }
  at_block_end = std::move(now);
}

Averages::Averages(const SystemState& system) : system_(system), layer_(system.plan().pairs)
{
  const SceneDefinition& scene = system.scene();
  const std::size_t species = scene.species.size();
  for (std::size_t s = 0; s < species; ++s)
    species_of_.push_back(s);
  for (const SizeClass& size_class : system.sizeClasses())
    species_of_.push_back(size_class.species);
  means_.begin(species_of_.size());
  if (scene.accuracy.mean_vx > 0.0 && !layer_)
    groups_.begin(species * GROUPS);
}

BlockSum Averages::path(std::uint32_t slot, double time) const
{
  const Trajectory& trajectory = system_.observers().trajectories()[slot];
  const Disk& disk = system_.disk(slot);
  const bool active = system_.active(slot);
  const double x = active ? positionAt(disk, time, system_.scene().gravity).x() : disk.position.x();
  const double until = active ? system_.epoch().start + time : trajectory.left_when;
  return {x + trajectory.offset - trajectory.counted_x, until - trajectory.counted_from};
}

void Averages::add(std::uint32_t slot, double time, std::vector<Sums>& sums) const
{
  const Disk& disk = system_.disk(slot);
  const SpeciesDefinition& species = system_.scene().species[disk.species];
  const TrajectorySums& trajectories = system_.observers().trajectories();
  const Trajectory trajectory =
      system_.active(slot) ? trajectories.until(slot, disk, time) : trajectories[slot];
  const BlockSum path = this->path(slot, time);
  const double mass = system_.properties(slot).mass;
  const double inertia = species.inertiaOf(mass, disk.radius) / species.inertia();
  for (const std::size_t row :
       {std::size_t{disk.species}, system_.scene().species.size() + system_.sizeClassOf(disk)})
  {
    if (row == sums.size())
      break;  // It is of no size class.
    Sums& sum = sums[row];
    sum.disks += 1.0;
    sum.path.sum += path.sum;
    sum.path.weight += path.weight;
    sum.displacement_squared += path.sum * path.sum;
    sum.displacement_time += path.sum * path.weight;
    sum.time_squared += path.weight * path.weight;
    sum.translation += mass / species.mass * trajectory.translation;
    sum.rotation += inertia * trajectory.rotation;
  }
}

void Averages::add(std::uint32_t slot, double time, std::vector<BlockSum>& groups) const
{
  const BlockSum path = this->path(slot, time);
  BlockSum& sum = groups[system_.disk(slot).species * GROUPS + system_.id(slot) % GROUPS];
  sum.sum += path.sum;
  sum.weight += path.weight;
}

template <typename Sum>
std::vector<Sum> Averages::sums(const Series<Sum>& series, double time) const
{
  std::vector<Sum> sums = series.gone;
  for (std::uint32_t slot = 0; slot < system_.disks().size(); ++slot)
    if (system_.observers().trajectories()[slot].counts())
      add(slot, time, sums);
  return sums;
}

void Averages::compact(const Compaction& compaction)
{
  for (const std::uint32_t slot : compaction.gone)
  {
    if (!system_.observers().trajectories()[slot].counts())
      continue;
    add(slot, 0.0, means_.gone);
    if (!groups_.blocks.empty())
      add(slot, 0.0, groups_.gone);
  }
}

void Averages::restart(double /*time*/)
{
  means_.begin(means_.blocks.size());
  groups_.begin(groups_.blocks.size());
}

void Averages::endBlock(double time)
{
  if (layer_)
    means_.endBlock(sums(means_, time));
  if (!groups_.blocks.empty())
    groups_.endBlock(sums(groups_, time));
}

SpeciesMeans Averages::Sums::means(const SpeciesDefinition& species) const
{
  SpeciesMeans means;
  const double time = path.weight;
  if (time <= 0.0)
    return means;
  const double vx = path.sum / time;
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

SpeciesMeans Averages::meansOf(std::size_t row, const std::vector<Sums>& sums) const
{
  SpeciesMeans means = sums[row].means(system_.scene().species[species_of_[row]]);
  if (!layer_ || !means.mean_vx)
    return means;
  // The larger one: from differences between disks, or from fluctuations of the whole layer in time.
  const std::optional<double> over_time = means_.blocks[row].standardError();
  means.mean_vx_stderr =
      over_time ? std::optional(std::max(means.mean_vx_stderr.value_or(0.0), *over_time)) : std::nullopt;
  return means;
}

std::vector<SpeciesMeans> Averages::means(double time) const
{
  const std::vector<Sums> all = sums(means_, time);
  std::vector<SpeciesMeans> means;
  for (std::size_t s = 0; s < system_.scene().species.size(); ++s)
  {
    means.push_back(meansOf(s, all));
    if (all[s].path.weight > 0.0)
      means[s].collision_rate =
          static_cast<double>(system_.observers().speciesContacts().of(s)) / all[s].path.weight;
  }
  return means;
}

std::vector<SpeciesMeans> Averages::sizeClassMeans(double time) const
{
  const std::vector<Sums> all = sums(means_, time);
  std::vector<SpeciesMeans> means;
  for (std::size_t row = system_.scene().species.size(); row < species_of_.size(); ++row)
    means.push_back(meansOf(row, all));
  return means;
}

MeanSeries Averages::series(double block_time) const
{
  const BlockAverages& first = (groups_.blocks.empty() ? means_.blocks : groups_.blocks).front();
  MeanSeries series{block_time * static_cast<double>(first.blockLength()), {}};
  for (std::size_t s = 0; s < system_.scene().species.size(); ++s)
  {
    SpeciesSeries& species = series.species.emplace_back();
    species.velocity = means_.blocks[s].blocks();
    if (groups_.blocks.empty())
      continue;
    species.velocity.assign(first.blocks().size(), {});
    for (std::size_t g = 0; g < GROUPS; ++g)
    {
      species.groups.push_back(groups_.blocks[s * GROUPS + g].blocks());
      for (std::size_t k = 0; k < species.velocity.size(); ++k)
      {
        species.velocity[k].sum += species.groups[g][k].sum;
        species.velocity[k].weight += species.groups[g][k].weight;
      }
    }
  }
  return series;
}

void Averages::archive(StateArchive& state)
{
  const std::size_t rows = groups_.blocks.size();
  state(means_.gone, means_.at_block_end, means_.blocks);
  state(groups_.gone, groups_.at_block_end, groups_.blocks);
  if (groups_.blocks.empty() && rows > 0)
    throw StateError("it lacks the series for the requested accuracy, which its own scene did not request");
  if (rows == 0)
    groups_.blocks.clear();
  groups_.gone.resize(rows);
  groups_.at_block_end.resize(rows);
  if (groups_.blocks.size() != rows || !sameLengths(groups_.blocks))
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
