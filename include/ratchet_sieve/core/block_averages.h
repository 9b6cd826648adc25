#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

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

  void archive(StateArchive& state) { state(blocks_, open_, samples_, block_length_); }

  /// Fewer blocks than this say nothing of their scatter.
  static constexpr std::size_t MIN_BLOCKS = 16;

private:
  struct Block
  {
    double displacement = 0.0;
    double time = 0.0;

    void archive(StateArchive& state) { state(displacement, time); }
  };

  static std::vector<Block> joined(const std::vector<Block>& blocks);
  static double errorOf(const std::vector<Block>& blocks);

  std::vector<Block> blocks_;
  Block open_;                    ///< gathers samples until it is as long as the others
  std::size_t samples_ = 0;       ///< in open_
  std::size_t block_length_ = 1;  ///< samples to a block
};

}  // namespace ratchet_sieve
