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
}  // namespace

Averages::Averages(const SystemState& system) : system_(system), layer_(system.plan().pairs)
{
  const SceneDefinition& scene = system.scene();
  const std::size_t species = scene.species.size();
  for (std::size_t s = 0; s < species; ++s)
    species_of_.push_back(s);
  for (const SizeClass& size_class : system.sizeClasses())
    species_of_.push_back(size_class.species);
  first_group_ = species_of_.size();
  if (scene.accuracy.mean_vx > 0.0 && !layer_)
    for (std::size_t group = 0; group < species * GROUPS; ++group)
      species_of_.push_back(group / GROUPS);
  restart();
}

/// A disk's displacement and time as far as they count, up to `time` or until it left.
BlockSum Averages::pathOf(std::uint32_t slot, double time) const
{
  const Disk& disk = system_.disk(slot);
  const DiskRecord& record = system_.record(slot);
  const double x = record.active ? positionAt(disk, time, system_.scene().gravity).x() : disk.position.x();
  const double until = record.active ? system_.epoch().start + time : record.left_when;
  return {x + record.offset - record.counted_x, until - record.counted_from};
}

/// Calls a function with each row that a disk belongs to.
template <typename Function>
void Averages::eachRow(std::uint32_t slot, const Function& function) const
{
  const Disk& disk = system_.disk(slot);
  const std::size_t species = system_.scene().species.size();
  function(disk.species);
  if (const std::size_t row = species + system_.sizeClassOf(disk); row < first_group_)
    function(row);
  if (hasGroups())
    function(first_group_ + disk.species * GROUPS + system_.id(slot) % GROUPS);
}

void Averages::add(std::uint32_t slot, double time, std::vector<Sums>& sums) const
{
  const Disk& disk = system_.disk(slot);
  const SpeciesDefinition& species = system_.scene().species[disk.species];
  DiskRecord record = system_.record(slot);
  if (record.active)
    record.fly(disk, time, system_.scene().gravity);
  const BlockSum path = pathOf(slot, time);
  const double mass = record.properties.mass;
  const double inertia = species.inertiaOf(mass, disk.radius) / species.inertia();
  eachRow(slot,
          [&](std::size_t row)
          {
            Sums& sum = sums[row];
            sum.disks += 1.0;
            sum.path.sum += path.sum;
            sum.path.weight += path.weight;
            sum.displacement_squared += path.sum * path.sum;
            sum.displacement_time += path.sum * path.weight;
            sum.time_squared += path.weight * path.weight;
            sum.translation += mass / species.mass * record.translation;
            sum.rotation += inertia * record.rotation;
          });
}

std::vector<Averages::Sums> Averages::sums(double time) const
{
  std::vector<Sums> sums = gone_;
  for (std::uint32_t slot = 0; slot < system_.disks().size(); ++slot)
    if (system_.record(slot).counts())
      add(slot, time, sums);
  return sums;
}

/// Of sums(), as they are at every end of a block.
std::vector<BlockSum> Averages::paths(double time) const
{
  std::vector<BlockSum> paths;
  for (const Sums& gone : gone_)
    paths.push_back(gone.path);
  for (std::uint32_t slot = 0; slot < system_.disks().size(); ++slot)
    if (system_.record(slot).counts())
      eachRow(slot,
              [&, path = pathOf(slot, time)](std::size_t row)
              {
                paths[row].sum += path.sum;
                paths[row].weight += path.weight;
              });
  return paths;
}

void Averages::close(std::uint32_t slot)
{
  add(slot, 0.0, gone_);
}

void Averages::restart()
{
  gone_.assign(species_of_.size(), {});
  at_block_end_.assign(species_of_.size(), {});
  blocks_.assign(species_of_.size(), {});
}

void Averages::endBlock(double time)
{
  if (!keepsSeries())
    return;
  const std::vector<BlockSum> now = paths(time);
  for (std::size_t row = layer_ ? 0 : first_group_; row < now.size(); ++row)
  {
    const BlockSum before = std::exchange(at_block_end_[row], now[row]);
    blocks_[row].add(now[row].sum - before.sum, now[row].weight - before.weight);
  }
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
  const std::optional<double> over_time = blocks_[row].standardError();
  means.mean_vx_stderr =
      over_time ? std::optional(std::max(means.mean_vx_stderr.value_or(0.0), *over_time)) : std::nullopt;
  return means;
}

std::vector<SpeciesMeans> Averages::means(double time) const
{
  const std::vector<Sums> all = sums(time);
  std::vector<SpeciesMeans> means;
  for (std::size_t s = 0; s < system_.scene().species.size(); ++s)
  {
    means.push_back(meansOf(s, all));
    if (all[s].path.weight > 0.0)
      means[s].collision_rate =
          static_cast<double>(system_.sums().contacts.of_species[s]) / all[s].path.weight;
  }
  return means;
}

std::vector<SpeciesMeans> Averages::sizeClassMeans(double time) const
{
  const std::vector<Sums> all = sums(time);
  std::vector<SpeciesMeans> means;
  for (std::size_t row = system_.scene().species.size(); row < first_group_; ++row)
    means.push_back(meansOf(row, all));
  return means;
}

MeanSeries Averages::series(double block_time) const
{
  const BlockAverages& first = blocks_[hasGroups() ? first_group_ : 0];
  MeanSeries series{block_time * static_cast<double>(first.blockLength()), {}};
  for (std::size_t s = 0; s < system_.scene().species.size(); ++s)
  {
    SpeciesSeries& species = series.species.emplace_back();
    species.velocity = blocks_[s].blocks();
    if (!hasGroups())
      continue;
    species.velocity.assign(first.blocks().size(), {});
    for (std::size_t g = 0; g < GROUPS; ++g)
    {
      species.groups.push_back(blocks_[first_group_ + s * GROUPS + g].blocks());
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
  const std::size_t rows = species_of_.size();
  state(gone_, at_block_end_, blocks_);
  if (hasGroups() && blocks_.size() == first_group_)
    throw StateError("it lacks the series for the requested accuracy, which its own scene did not request");
  const bool fits =
      blocks_.size() >= rows && gone_.size() == blocks_.size() && at_block_end_.size() == blocks_.size();
  gone_.resize(rows);
  at_block_end_.resize(rows);
  blocks_.resize(rows);
  const auto as_long = [this](const BlockAverages& row)
  { return row.blocks().size() == blocks_.back().blocks().size(); };
  if (!fits || !std::all_of(blocks_.begin() + (layer_ ? 0 : static_cast<std::ptrdiff_t>(first_group_)),
                            blocks_.end(), as_long))
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
