#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/core/mean_series.h"
#include "ratchet_sieve/core/segregation.h"
#include "ratchet_sieve/recording/steady_mean.h"

namespace ratchet_sieve
{

/// Q of what has left so far (bestQuality()).
struct QualityEstimate
{
  Estimate estimate;             ///< with what the disks still in the machine could change
  double sampled = 0.0;          ///< the half-width without that
  double times_for_trust = 1.0;  ///< so many times as long a run is needed for the estimate to be trusted
};

/// Q = |p_a - p_b|, p the share of a species that left to the left: the difference of two proportions. Its
/// interval is made of Wilson's of each (R. G. Newcombe, Stat. Med. 17, 873 (1998), method 10), which is none
/// of no width where all have left to one side. Disks that leave one after the other leave together: of a
/// machine that is fed, the error is found of the course in time as well, and the larger one counts. Disks
/// that are still in a machine that is not fed widen the interval by what Q would change if they left to the
/// worst side.
/// @param exits per species, see SpeciesSeries; empty where the machine is not fed
/// @return nothing while Q is not defined, or too little of the course is known
std::optional<QualityEstimate> qualityEstimate(const std::vector<SpeciesBins>& bins,
                                               const std::vector<std::vector<BlockSum>>& exits,
                                               double confidence);

}  // namespace ratchet_sieve
