#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace ratchet_sieve
{

/// One block of a series, for the mean of a ratio: the sum of the displacements and the sum of the times, for
/// example.
struct BlockSum
{
  double sum = 0.0;
  double weight = 0.0;

  template <typename Archive>
  void archive(Archive& state)
  {
    state(sum, weight);
  }
};

/// The standard error of the ratio, and the number of independent blocks from which an error as certain would
/// come.
struct BlockError
{
  double error = 0.0;
  std::size_t blocks = 0;
};

/// The standard error from the scatter of the blocks' sums about ratio times weight. Needs two blocks at
/// least; 0 if all weights are 0.
double scatterError(const std::vector<BlockSum>& blocks);

/// The standard error of the ratio over a correlated series: the correlations of its blocks are added up,
/// over a window that ends where a longer one would add more noise than it finds. U. Wolff, Comput. Phys.
/// Commun. 156, 143 (2004), doi:10.1016/S0010-4655(03)00467-3. If the sums of the blocks stay within bounds,
/// as displacements of trapped disks do, it is that of the bounds; otherwise it is never less than that of
/// independent blocks. Nothing if the series is too short to tell: fewer than BlockAverages::MIN_BLOCKS
/// blocks with a weight, or fewer than six correlation times.
std::optional<BlockError> seriesError(const std::vector<BlockSum>& blocks);

/// The standard error of a mean velocity over a correlated series. The samples of one run are correlated: the
/// layer of disks speeds up and slows down as a whole, and the average over disks does not reduce that.
/// Memory does not grow with the series: neighbouring blocks are joined.
class BlockAverages
{
public:
  /// Adds the next sample: displacement [m] and time [s], each summed over the disks present. All samples
  /// span the same time. When disks enter and leave, a sample weighs by the number of disks.
  void add(double displacement, double time);

  /// Standard error of (sum of displacements) / (sum of times) [m/s]; see seriesError().
  std::optional<double> standardError() const
  {
    const std::optional<BlockError> found = seriesError(blocks_);
    return found ? std::optional<double>(found->error) : std::nullopt;
  }

  /// The complete blocks, in order, of blockLength() samples each. The incomplete last block is left out.
  const std::vector<BlockSum>& blocks() const { return blocks_; }
  std::size_t blockLength() const { return block_length_; }

  template <typename Archive>
  void archive(Archive& state)
  {
    state(blocks_, open_, samples_, block_length_);
  }

  /// With fewer blocks than this the layer of Fig. 8, which remembers four to six periods of the drive, has
  /// errors that are more than 10 % too small.
  static constexpr std::size_t MIN_BLOCKS = 48;

private:
  std::vector<BlockSum> blocks_;
  BlockSum open_;                 ///< the incomplete block that collects samples
  std::size_t samples_ = 0;       ///< in open_
  std::size_t block_length_ = 1;  ///< samples to a block
};

/// One species' part of a MeanSeries.
struct SpeciesSeries
{
  std::vector<BlockSum> velocity;  ///< displacement [m] over time [s], each summed over the disks

  /// Displacement over time of groups of independent disks. Empty if disks collide with each other.
  std::vector<std::vector<BlockSum>> groups;
};

/// The series from which the means since `settle` are computed, in blocks of time. For an ensemble of
/// independent disks it is recorded only if the scene sets accuracy.mean_vx. Neighbouring blocks are joined
/// as the run gets longer: there are at most a few hundred.
struct MeanSeries
{
  double block_time = 0.0;  ///< of each block [s]
  std::vector<SpeciesSeries> species;
};

}  // namespace ratchet_sieve
