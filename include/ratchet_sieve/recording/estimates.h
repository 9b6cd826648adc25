#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "ratchet_sieve/statistics/block_averages.h"
#include "ratchet_sieve/statistics/segregation.h"

namespace ratchet_sieve
{

/// A mean is reliable once its series contains at least this many independent blocks. With fewer, runs end
/// too often with an error that is too small by chance (docs/accuracy.md).
constexpr double INDEPENDENT_BLOCKS = 128.0;

/// A mean is reliable once its series is at least this many times as long as the transient that is cut off.
constexpr std::size_t CUTS_IN_A_RUN = 10;

/// A value and the half-width of its confidence interval.
struct Estimate
{
  double value = 0.0;
  double half_width = 0.0;
};

/// The sum of all blocks.
BlockSum sumOf(const std::vector<BlockSum>& blocks);

/// Half-width of the confidence interval over the standard error, for an error estimated from this number of
/// blocks: Student's t. 0 blocks: a known error, normal distribution.
double halfWidthOver(double confidence, std::size_t blocks);

/// Half-width of the ratio over a correlated series: the larger one of those from seriesError() and from the
/// scatter of ten batches, which shows correlations that are weak but last. B. Schmeiser, Oper. Res. 30, 556
/// (1982), doi:10.1287/opre.30.3.556. Nothing as seriesError().
std::optional<double> correlatedHalfWidth(const std::vector<BlockSum>& blocks, double confidence);

/// The difference of the fractions of two species in each block, relative to the overall one: its error is
/// that of s. @param a, b as the exits of separationEstimate()
std::vector<BlockSum> separationDeviations(const std::vector<BlockSum>& a, const std::vector<BlockSum>& b);

/// The factor by which the series must be longer for a reliable error; see INDEPENDENT_BLOCKS. @param error
/// of the series
double timesForTrust(const std::vector<BlockSum>& series, const BlockError& error);

/// The number of blocks at the start of a series that are transient. MSER: the cut that minimises the squared
/// standard error of the rest, computed as for independent blocks. K. P. White, Simulation 69, 323 (1997),
/// doi:10.1177/003754979706900601. Only cuts within the first half are considered. The series is first
/// grouped into 64 to 127 batches.
std::size_t steadyFrom(const std::vector<BlockSum>& series);

/// ⟨V_x⟩ of one species over the steady part of a series.
struct SteadyMean
{
  Estimate estimate;  ///< [m/s]

  /// The factor by which the steady part must be longer for a reliable estimate.
  double times_for_trust = 1.0;
};

/// The steady part of a run.
struct SteadyMeans
{
  /// Length of the transient that is cut off [s]: twice the result of steadyFrom() for the species with the
  /// longest transient, because the end of a transient is hidden in the noise. Nothing if that is more than
  /// half of the series.
  std::optional<double> transient;

  /// Whether the run is long enough to be sure that the transient is over: CUTS_IN_A_RUN.
  bool settled = false;

  double left = 0.0;                          ///< length of the steady part [s]
  std::vector<std::optional<SteadyMean>> of;  ///< per species; nothing if there are too few blocks
};

/// Means with their errors. If disks collide with each other, the error is estimated from the time series
/// (seriesError()). For independent disks it is also estimated from the scatter between groups of disks, and
/// the larger one is used.
SteadyMeans steadyMeans(const MeanSeries& series, double confidence);

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
/// @param exits per species, what left on the left of all that left; empty without a feed
/// @return nothing if s is undefined or the series is too short
std::optional<SeparationEstimate> separationEstimate(const std::vector<SpeciesBins>& bins,
                                                     const std::vector<std::vector<BlockSum>>& exits,
                                                     double confidence);

}  // namespace ratchet_sieve
