#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// One block of a series of which the ratio of the sums is wanted: of displacements over times, say.
struct BlockSum
{
  double sum = 0.0;
  double weight = 0.0;

  void archive(StateArchive& state) { state(sum, weight); }
};

/// The standard error of such a ratio, and of how many blocks it was found.
struct BlockError
{
  double error = 0.0;
  std::size_t blocks = 0;
};

/// From the scatter of each block's sum about the ratio times its weight. Of two blocks at least; 0 where
/// nothing weighs.
double scatterError(const std::vector<BlockSum>& blocks);

/// The largest of the errors that the series has as it is and as neighbouring blocks are joined, down to
/// BlockAverages::MIN_BLOCKS; nothing for fewer.
std::optional<BlockError> joinedError(std::vector<BlockSum> blocks);

/// The standard error of a mean velocity over a series whose members are correlated, as those of one
/// run are: the layer of disks moves as a whole now faster, now slower, and averaging over disks does
/// not see it. Neighbouring blocks of time are joined until the scatter of the blocks' means says
/// the same at every size; the largest error over the sizes is taken. H. Flyvbjerg & H. G. Petersen,
/// J. Chem. Phys. 91, 461 (1989), doi:10.1063/1.457480. Memory does not grow with the series.
class BlockAverages
{
public:
  /// The next sample of the series: the displacement [m] and the time [s], each summed over the disks
  /// that were there. All samples are of one length in time; with disks that come and go they weigh by
  /// how many there were.
  void add(double displacement, double time);

  /// Of the sum of displacements over the sum of times [m/s]; nothing for fewer than MIN_BLOCKS samples.
  std::optional<double> standardError() const;

  /// Those that are full, in order; each of blockLength() samples, of which the rest is left out.
  const std::vector<BlockSum>& blocks() const { return blocks_; }
  std::size_t blockLength() const { return block_length_; }

  void archive(StateArchive& state) { state(blocks_, open_, samples_, block_length_); }

  /// Fewer blocks than this say nothing of their scatter.
  static constexpr std::size_t MIN_BLOCKS = 16;

private:
  std::vector<BlockSum> blocks_;
  BlockSum open_;                 ///< gathers samples until it is as long as the others
  std::size_t samples_ = 0;       ///< in open_
  std::size_t block_length_ = 1;  ///< samples to a block
};

}  // namespace ratchet_sieve
