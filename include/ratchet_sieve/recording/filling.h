#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/statistics/flow_series.h"

namespace ratchet_sieve
{

/// When a machine with a feed has filled.
struct Filling
{
  /// The number of blocks at the start of the series until it has; nothing if it has not, or if the series is
  /// too short to tell.
  std::optional<std::size_t> blocks;
  std::string reason;           ///< why not, in one line; empty if it has
  std::optional<double> needs;  ///< the least length of a series that may tell [s]; nothing if not known
};

/// The machine has filled once all of these hold; at the latest at half of the series:
/// - The cut by MSER of the number of disks inside has passed, for every species: steadyFrom().
/// - Three mean residence times of the slowest species have passed. They are the mean number inside over the
///   throughput: J. D. C. Little, Oper. Res. 9, 383 (1961), doi:10.1287/opre.9.3.383.
/// - Neither the number inside of a species nor the share of it that leaves on the left drifts in the rest:
///   the Cramer-von Mises test of P. Heidelberger and P. D. Welch, Oper. Res. 31, 1109 (1983),
///   doi:10.1287/opre.31.6.1109, at 1 %. The noise is that of the second half of the series (seriesError())
///   about a straight line, but at least that of disks which are fed, convey and part independently of each
///   other.
/// @param names of the species
Filling fillingOf(const FlowSeries& series, const std::vector<std::string>& names);

/// Blocks from this one on.
std::vector<BlockSum> blocksFrom(const std::vector<BlockSum>& blocks, std::size_t first);

/// The part of each block that left on the left, of all that left.
std::vector<BlockSum> leftShare(const std::vector<BlockSum>& left, const std::vector<BlockSum>& right);

}  // namespace ratchet_sieve
