#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/core/block_averages.h"
#include "ratchet_sieve/core/segregation.h"
#include "ratchet_sieve/recording/steady_mean.h"

namespace ratchet_sieve
{

/// An estimate of s from the disks that have left so far (bestSeparation()). Q = |s| has the same half-width.
struct SeparationEstimate
{
  Estimate estimate;             ///< including the disks that are still in the machine
  double sampled = 0.0;          ///< the half-width without those disks
  double times_for_trust = 1.0;  ///< factor by which the run must be longer for a reliable estimate
};

/// s = p_a - p_b, where p is the fraction of a species that left on the left: a difference of two
/// proportions. The interval is built from the Wilson interval of each proportion (R. G. Newcombe, Stat. Med.
/// 17, 873 (1998), method 10). Its width is not 0 even if all disks left on one side. Disks that leave one
/// after the other are correlated: for a machine with a feed, the error is estimated from the time series as
/// well, and the larger one is used. Disks that are still in a machine without a feed widen the interval by
/// the change of s if they all left on the worst side.
/// @param exits per species, see SpeciesSeries; empty without a feed
/// @return nothing if s is undefined or the series is too short
std::optional<SeparationEstimate> separationEstimate(const std::vector<SpeciesBins>& bins,
                                                     const std::vector<std::vector<BlockSum>>& exits,
                                                     double confidence);

}  // namespace ratchet_sieve
