#pragma once

#include <vector>

#include "ratchet_sieve/core/block_averages.h"

namespace ratchet_sieve
{

/// One species' part of a MeanSeries.
struct SpeciesSeries
{
  std::vector<BlockSum> velocity;  ///< displacement [m] over time [s], each summed over the disks

  /// The same of groups of disks that know nothing of each other. None where all disks see each other.
  std::vector<std::vector<BlockSum>> groups;

  /// Disks that left to the left over all that left. Kept where a scene that is fed asks for
  /// accuracy.quality.
  std::vector<BlockSum> exits;
};

/// What the means since `settle` are made of, block by block of time. Of disks that do not see each other it
/// is kept for scenes that ask for accuracy.mean_vx alone. As a run gets longer its blocks are joined: there
/// are some hundreds at most.
struct MeanSeries
{
  double block_time = 0.0;  ///< of each block [s]
  std::vector<SpeciesSeries> species;
};

}  // namespace ratchet_sieve
