#include "ratchet_sieve/core/block_averages.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// When there are as many blocks, neighbours are joined.
constexpr std::size_t MAX_BLOCKS = 512;
}  // namespace

void BlockAverages::add(double displacement, double time)
{
  open_.displacement += displacement;
  open_.time += time;
  if (++samples_ < block_length_)
    return;
  blocks_.push_back(open_);
  open_ = Block();
  samples_ = 0;
  if (blocks_.size() < MAX_BLOCKS)
    return;
  blocks_ = joined(blocks_);
  block_length_ *= 2;
}

std::vector<BlockAverages::Block> BlockAverages::joined(const std::vector<Block>& blocks)
{
  std::vector<Block> pairs;
  for (std::size_t i = 0; i + 1 < blocks.size(); i += 2)
    pairs.push_back(
        {blocks[i].displacement + blocks[i + 1].displacement, blocks[i].time + blocks[i + 1].time});
  return pairs;
}

/// Of the ratio of the sums, from the scatter of each block's displacement about the mean velocity
/// times its time.
double BlockAverages::errorOf(const std::vector<Block>& blocks)
{
  Block sum;
  for (const Block& block : blocks)
  {
    sum.displacement += block.displacement;
    sum.time += block.time;
  }
  if (sum.time <= 0.0)
    return 0.0;
  double scatter = 0.0;
  for (const Block& block : blocks)
  {
    const double deviation = block.displacement - sum.displacement / sum.time * block.time;
    scatter += deviation * deviation;
  }
  const auto count = static_cast<double>(blocks.size());
  return std::sqrt(scatter * count / (count - 1.0)) / sum.time;
}

std::optional<double> BlockAverages::standardError() const
{
  if (blocks_.size() < MIN_BLOCKS)
    return std::nullopt;
  double error = 0.0;
  for (std::vector<Block> blocks = blocks_; blocks.size() >= MIN_BLOCKS; blocks = joined(blocks))
    error = std::max(error, errorOf(blocks));
  return error;
}

}  // namespace ratchet_sieve
