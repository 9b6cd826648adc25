#pragma once

#include <vector>

#include "ratchet_sieve/core/block_averages.h"

namespace ratchet_sieve
{

/// One species' part of a MeanSeries.
struct SpeciesSeries
{
  std::vector<BlockSum> velocity;  ///< displacement [m] over time [s], each summed over the disks

  /// The same for groups of independent disks. Empty if disks collide with each other.
  std::vector<std::vector<BlockSum>> groups;

  /// Disks that left on the left over all disks that left. Recorded for several species on an open base with
  /// a feed.
  std::vector<BlockSum> exits;
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
