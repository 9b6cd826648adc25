#include "observe/flow_blocks.h"

#include <algorithm>

namespace ratchet_sieve
{
namespace
{
/// The blocks with their times as weights.
std::vector<BlockSum> timed(const BlockAverages& averages, double block_time)
{
  std::vector<BlockSum> blocks = averages.blocks();
  for (BlockSum& block : blocks)
    block.weight *= block_time;
  return blocks;
}
}  // namespace

FlowBlocks::FlowBlocks(const Bins& bins) : bins_(bins), rows_(bins.ofSpecies().size()) {}

void FlowBlocks::restart(double /*time*/)
{
  for (std::size_t s = 0; s < rows_.size(); ++s)
  {
    rows_[s] = Row();
    rows_[s].before = bins_.ofSpecies()[s];
  }
}

void FlowBlocks::endBlock(double /*time*/)
{
  const auto add = [](Bin& bin, std::uint64_t number, double mass)
  {
    bin.number.add(static_cast<double>(number), 1.0);
    bin.mass.add(mass, 1.0);
  };
  for (std::size_t s = 0; s < rows_.size(); ++s)
  {
    Row& row = rows_[s];
    const SpeciesBins& now = bins_.ofSpecies()[s];
    add(row.left, now.left - row.before.left, now.left_mass - row.before.left_mass);
    add(row.right, now.right - row.before.right, now.right_mass - row.before.right_mass);
    row.inside.add(static_cast<double>(now.on_base), 1.0);
    row.before = now;
  }
}

FlowSeries FlowBlocks::series(double start, double block_time) const
{
  FlowSeries series{start, block_time * static_cast<double>(rows_.front().inside.blockLength()), {}};
  const auto flow = [block_time](const Bin& bin) {
    return BinFlow{timed(bin.number, block_time), timed(bin.mass, block_time)};
  };
  for (const Row& row : rows_)
  {
    SpeciesFlow& species = series.species.emplace_back(
        SpeciesFlow{flow(row.left), flow(row.right), timed(row.inside, block_time)});
    for (BlockSum& block : species.inside)
      block.sum *= block_time;
  }
  return series;
}

void FlowBlocks::archive(StateArchive& state)
{
  const std::size_t species = rows_.size();
  state(rows_);
  const auto fits = [this](const BlockAverages& averages)
  { return averages.blocks().size() == rows_.front().inside.blocks().size(); };
  if (rows_.size() != species || !std::all_of(rows_.begin(), rows_.end(),
                                              [&fits](const Row& row)
                                              {
                                                return fits(row.inside) && fits(row.left.number) &&
                                                       fits(row.left.mass) && fits(row.right.number) &&
                                                       fits(row.right.mass);
                                              }))
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
