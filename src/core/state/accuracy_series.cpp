#include "state/accuracy_series.h"

#include <algorithm>
#include <utility>

#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{

/// Number of groups: enough for a relative accuracy of 10 % of the error, few enough to store their series.
constexpr std::size_t GROUPS = 64;

BlockSum exitsOf(const SpeciesBins& bins)
{
  return {static_cast<double>(bins.left), static_cast<double>(bins.counted())};
}

bool sameLengths(const std::vector<BlockAverages>& rows)
{
  return std::all_of(rows.begin(), rows.end(),
                     [&rows](const BlockAverages& row)
                     { return row.blocks().size() == rows.front().blocks().size(); });
}

}  // namespace

AccuracySeries::AccuracySeries(const SystemState& system) : system_(system)
{
  const SceneDefinition& scene = system.scene();
  const std::size_t species = scene.species.size();
  if (scene.accuracy.mean_vx > 0.0 && !system.plan().pairs)
  {
    gone_.resize(species * GROUPS);
    at_block_end_.resize(species * GROUPS);
    groups_.resize(species * GROUPS);
  }
  if (scene.feed.rate > 0.0 && scene.boundary != Boundary::PERIODIC && species > 1)
  {
    exited_.resize(species);
    exits_.resize(species);
  }
}

std::size_t AccuracySeries::row(std::uint32_t slot) const
{
  return system_.disk(slot).species * GROUPS + system_.id(slot) % GROUPS;
}

void AccuracySeries::addTrajectory(std::uint32_t slot, double x, double until,
                                   std::vector<BlockSum>& sums) const
{
  const Trajectory& trajectory = system_.observers().trajectories()[slot];
  if (!trajectory.counts())
    return;
  BlockSum& sum = sums[row(slot)];
  sum.sum += x + trajectory.offset - trajectory.counted_x;
  sum.weight += until - trajectory.counted_from;
}

void AccuracySeries::compact(const Compaction& compaction)
{
  if (groups_.empty())
    return;
  for (const std::uint32_t slot : compaction.gone)
    addTrajectory(slot, system_.disk(slot).position.x(), system_.observers().trajectories()[slot].left_when,
                  gone_);
}

void AccuracySeries::restart(double /*time*/)
{
  std::fill(gone_.begin(), gone_.end(), BlockSum());
  std::fill(at_block_end_.begin(), at_block_end_.end(), BlockSum());
  std::fill(groups_.begin(), groups_.end(), BlockAverages());
  std::fill(exits_.begin(), exits_.end(), BlockAverages());
  for (std::size_t s = 0; s < exited_.size(); ++s)
    exited_[s] = exitsOf(system_.observers().bins()[s]);
}

void AccuracySeries::endBlock(double time)
{
  if (!groups_.empty())
    endGroups(time);
  if (!exits_.empty())
    endExits();
}

void AccuracySeries::endGroups(double time)
{
  std::vector<BlockSum> now = gone_;
  const double gravity = system_.scene().gravity;
  for (std::uint32_t slot = 0; slot < system_.disks().size(); ++slot)
  {
    const Disk& disk = system_.disk(slot);
    if (system_.active(slot))
      addTrajectory(slot, flown(disk, time, gravity).position.x(), system_.epoch().start + time, now);
    else
      addTrajectory(slot, disk.position.x(), system_.observers().trajectories()[slot].left_when, now);
  }
  for (std::size_t k = 0; k < groups_.size(); ++k)
    groups_[k].add(now[k].sum - at_block_end_[k].sum, now[k].weight - at_block_end_[k].weight);
  at_block_end_ = std::move(now);
}

void AccuracySeries::endExits()
{
  for (std::size_t s = 0; s < exits_.size(); ++s)
  {
    const BlockSum now = exitsOf(system_.observers().bins()[s]);
    exits_[s].add(now.sum - exited_[s].sum, now.weight - exited_[s].weight);
    exited_[s] = now;
  }
}

void AccuracySeries::addTo(MeanSeries& series) const
{
  for (std::size_t s = 0; s < series.species.size(); ++s)
  {
    SpeciesSeries& species = series.species[s];
    if (!exits_.empty())
      species.exits = exits_[s].blocks();
    if (groups_.empty())
      continue;
    species.velocity.assign(groups_[s * GROUPS].blocks().size(), {});
    for (std::size_t g = 0; g < GROUPS; ++g)
    {
      species.groups.push_back(groups_[s * GROUPS + g].blocks());
      for (std::size_t k = 0; k < species.velocity.size(); ++k)
      {
        species.velocity[k].sum += species.groups[g][k].sum;
        species.velocity[k].weight += species.groups[g][k].weight;
      }
    }
  }
}

void AccuracySeries::archive(StateArchive& state)
{
  const std::size_t rows = groups_.size();
  const std::size_t species = exits_.size();
  state(gone_, at_block_end_, groups_, exited_, exits_);
  if (groups_.empty() && rows > 0)
    throw StateError("it lacks the series for the requested accuracy, which its own scene did not request");
  if (rows == 0)
    groups_.clear();
  gone_.resize(rows);
  at_block_end_.resize(rows);
  exited_.resize(species);
  if (groups_.size() != rows || exits_.size() != species || !sameLengths(groups_) || !sameLengths(exits_))
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
