#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/mean_series.h"

namespace ratchet_sieve
{

/// A mean is trusted once its series has as much to say as so many independent blocks: of fewer, an error by
/// which the run ends is too often too small (docs/accuracy.md).
constexpr double INDEPENDENT_BLOCKS = 128.0;

/// And once the series is so many times as long as what is cut of it.
constexpr std::size_t CUTS_IN_A_RUN = 10;

/// A value and how far from it the truth is at most, with a confidence.
struct Estimate
{
  double value = 0.0;
  double half_width = 0.0;
};

/// Of all blocks.
BlockSum sumOf(const std::vector<BlockSum>& blocks);

/// Half-width of the interval of a confidence over the standard error, of an error that was found of so many
/// blocks: Student's t. 0 blocks: of an error that is known, the normal distribution.
double halfWidthOver(double confidence, std::size_t blocks);

/// So many times as long a series is needed for its error to be trusted; see INDEPENDENT_BLOCKS. @param error
/// of it
double timesForTrust(const std::vector<BlockSum>& series, const BlockError& error);

/// Where a series that begins with a transient has become steady, in blocks: where the squared standard error
/// of what is left, as if its blocks were independent, is least. Sought in the first half of the series.
/// In batches of blocks, 64 to 127 of them. MSER: K. P. White, Simulation 69, 323 (1997),
/// doi:10.1177/003754979706900601.
std::size_t steadyFrom(const std::vector<BlockSum>& series);

/// <V_x> of one species over what is left of a series.
struct SteadyMean
{
  Estimate estimate;  ///< [m/s]

  /// So many times as much as is left of the series is needed for the estimate to be trusted.
  double times_for_trust = 1.0;
};

/// The steady part of a run.
struct SteadyMeans
{
  /// Cut from the series' beginning [s]: twice what steadyFrom() finds, of the species that takes longest,
  /// for what of a transient is lost in the noise is still there. Nothing while that is more than half of the
  /// series.
  std::optional<double> transient;

  /// Whether the run is so long that the transient is known to be over: CUTS_IN_A_RUN.
  bool settled = false;

  double left = 0.0;                          ///< after the cut [s]
  std::vector<std::optional<SteadyMean>> of;  ///< per species; nothing where there are too few blocks
};

/// Means with their errors. Where disks see each other the error is found of the course in time, and
/// neighbouring blocks are joined until it grows no more (joinedError()). Of disks that do not see each other
/// it is found of the scatter of groups of them as well, and the larger one counts.
SteadyMeans steadyMeans(const MeanSeries& series, double confidence);

}  // namespace ratchet_sieve
