#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// One block of a series, for the mean of a ratio: the sum of the displacements and the sum of the times, for
/// example.
struct BlockSum
{
  double sum = 0.0;
  double weight = 0.0;

  void archive(StateArchive& state) { state(sum, weight); }
};

/// The standard error of the ratio, and the number of blocks from which it was estimated.
struct BlockError
{
  double error = 0.0;
  std::size_t blocks = 0;
};

/// The standard error from the scatter of the blocks' sums about ratio times weight. Needs two blocks at
/// least; 0 if all weights are 0.
double scatterError(const std::vector<BlockSum>& blocks);

/// The largest of the standard errors of the series at every block size: as it is, and with neighbouring
/// blocks joined again and again, down to BlockAverages::MIN_BLOCKS blocks. Nothing for a shorter series.
std::optional<BlockError> joinedError(std::vector<BlockSum> blocks);

/// The standard error of a mean velocity over a correlated series. The samples of one run are correlated: the
/// layer of disks speeds up and slows down as a whole, and the average over disks does not reduce that.
/// Neighbouring blocks of time are joined until the error no longer depends on the block size; the largest
/// error over all sizes is used. H. Flyvbjerg & H. G. Petersen, J. Chem. Phys. 91, 461 (1989),
/// doi:10.1063/1.457480. Memory does not grow with the series.
class BlockAverages
{
public:
  /// Adds the next sample: displacement [m] and time [s], each summed over the disks present. All samples
  /// span the same time. When disks enter and leave, a sample weighs by the number of disks.
  void add(double displacement, double time);

  /// Standard error of (sum of displacements) / (sum of times) [m/s]; nothing for fewer than MIN_BLOCKS
  /// samples.
  std::optional<double> standardError() const;

  /// The complete blocks, in order, of blockLength() samples each. The incomplete last block is left out.
  const std::vector<BlockSum>& blocks() const { return blocks_; }
  std::size_t blockLength() const { return block_length_; }

  void archive(StateArchive& state)
  {
    state(blocks_, open_, samples_, block_length_);
    state.require(block_length_ > 0 && samples_ < block_length_, "the block length of its means is 0");
  }

  /// Fewer blocks than this give no reliable scatter.
  static constexpr std::size_t MIN_BLOCKS = 16;

private:
  std::vector<BlockSum> blocks_;
  BlockSum open_;                 ///< the incomplete block that collects samples
  std::size_t samples_ = 0;       ///< in open_
  std::size_t block_length_ = 1;  ///< samples to a block
};

}  // namespace ratchet_sieve
