#pragma once

#include <vector>

#include "ratchet_sieve/statistics/block_averages.h"

namespace ratchet_sieve
{

/// What fell into one bin of one species. The weights are times [s].
struct BinFlow
{
  std::vector<BlockSum> number;
  std::vector<BlockSum> mass;  ///< [kg]
};

/// One species' part of a FlowSeries.
struct SpeciesFlow
{
  BinFlow left;
  BinFlow right;

  /// Disks in the machine times time [s], over time.
  std::vector<BlockSum> inside;
};

/// What left a machine with a feed, and what was in it, in blocks of time from the end of `settle` on.
/// Neighbouring blocks are joined as the run gets longer: there are at most a few hundred.
struct FlowSeries
{
  double start = 0.0;                ///< of the first block, in the run's time [s]
  double block_time = 0.0;           ///< of each block [s]
  std::vector<SpeciesFlow> species;  ///< empty without a feed, and if no disk can leave
};

}  // namespace ratchet_sieve
