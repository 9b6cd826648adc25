#include "ratchet_sieve/core/block_averages.h"

#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// At this number of blocks, neighbours are joined.
constexpr std::size_t MAX_BLOCKS = 512;

std::vector<BlockSum> joined(const std::vector<BlockSum>& blocks)
{
  std::vector<BlockSum> pairs;
  for (std::size_t i = 0; i + 1 < blocks.size(); i += 2)
    pairs.push_back({blocks[i].sum + blocks[i + 1].sum, blocks[i].weight + blocks[i + 1].weight});
  return pairs;
}
}  // namespace

void BlockAverages::add(double displacement, double time)
{
  open_.sum += displacement;
  open_.weight += time;
  if (++samples_ < block_length_)
    return;
  blocks_.push_back(open_);
  open_ = BlockSum();
  samples_ = 0;
  if (blocks_.size() < MAX_BLOCKS)
    return;
  blocks_ = joined(blocks_);
  block_length_ *= 2;
}

double scatterError(const std::vector<BlockSum>& blocks)
{
  BlockSum all;
  for (const BlockSum& block : blocks)
  {
    all.sum += block.sum;
    all.weight += block.weight;
  }
  if (all.weight <= 0.0)
    return 0.0;
  double scatter = 0.0;
  for (const BlockSum& block : blocks)
  {
    const double deviation = block.sum - all.sum / all.weight * block.weight;
    scatter += deviation * deviation;
  }
  const auto count = static_cast<double>(blocks.size());
  return std::sqrt(scatter * count / (count - 1.0)) / all.weight;
}

std::optional<BlockError> joinedError(std::vector<BlockSum> blocks)
{
  std::optional<BlockError> largest;
  for (; blocks.size() >= BlockAverages::MIN_BLOCKS; blocks = joined(blocks))
    if (const double error = scatterError(blocks); !largest || error > largest->error)
      largest = {error, blocks.size()};
  return largest;
}

std::optional<double> BlockAverages::standardError() const
{
  const std::optional<BlockError> largest = joinedError(blocks_);
  return largest ? std::optional<double>(largest->error) : std::nullopt;
}

}  // namespace ratchet_sieve
