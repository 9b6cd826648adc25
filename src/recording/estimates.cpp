#include "ratchet_sieve/recording/estimates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

#include "ratchet_sieve/recording/proportions.h"

namespace ratchet_sieve
{
namespace
{

/// The transient that remains after MSER is as large as the noise; its effect on the mean decreases with the
/// length of the series. See SteadyMeans.
constexpr std::size_t POINTS_CUT = 2;

/// Blocks are grouped until there are at most twice as many batches: a transient is found if it is larger
/// than the scatter of the batches.
constexpr std::size_t BATCHES = 64;

/// Number of blocks for finding the transient, if the errors come from groups.
constexpr double BLOCKS_OF_GROUPS = 32.0;

/// Fewer groups than this give no reliable scatter.
constexpr std::size_t MIN_GROUPS = 16;

/// Without blocks in which there was no disk.
std::vector<BlockSum> after(const std::vector<BlockSum>& series, std::size_t cut)
{
  std::vector<BlockSum> left;
  for (std::size_t k = cut; k < series.size(); ++k)
    if (series[k].weight > 0.0)
      left.push_back(series[k]);
  return left;
}

/// The sum of each group after the cut, without groups that have no disks.
std::vector<BlockSum> groupSums(const SpeciesSeries& species, std::size_t cut)
{
  std::vector<BlockSum> sums;
  for (const std::vector<BlockSum>& group : species.groups)
    if (const BlockSum sum = sumOf(after(group, cut)); sum.weight > 0.0)
      sums.push_back(sum);
  return sums;
}

/// Groups blocks into batches of this size, without the remainder at the end.
std::vector<BlockSum> batchesOf(const std::vector<BlockSum>& series, std::size_t size)
{
  std::vector<BlockSum> batches;
  for (std::size_t first = 0; first + size <= series.size(); first += size)
    batches.push_back(sumOf({series.begin() + static_cast<std::ptrdiff_t>(first),
                             series.begin() + static_cast<std::ptrdiff_t>(first + size)}));
  return batches;
}

/// MSER, in blocks of the series it is given.
std::size_t leastErrorFrom(const std::vector<BlockSum>& series)
{
  std::size_t weighty = 0;
  double sums = 0.0, weights = 0.0, squares = 0.0, products = 0.0, squared_weights = 0.0;
  double least = std::numeric_limits<double>::infinity();
  std::size_t from = 0;
  for (std::size_t k = series.size(); k-- > 0;)
  {
    const auto [sum, weight] = series[k];
    sums += sum;
    weights += weight;
    squares += sum * sum;
    products += sum * weight;
    squared_weights += weight * weight;
    weighty += weight > 0.0 ? 1 : 0;
    // An emptied machine: the motion of the last disks is no steady state.
    if (2 * k > series.size() || 2 * weighty < series.size() - k)
      continue;
    const double mean = sums / weights;
    const double error =
        (squares - 2.0 * mean * products + mean * mean * squared_weights) / (weights * weights);
    if (error > least)
      continue;
    least = error;
    from = k;
  }
  return from;
}

std::optional<SteadyMean> meanAfter(const SpeciesSeries& species, std::size_t cut, double confidence)
{
  const std::vector<BlockSum> left = after(species.velocity, cut);
  const BlockSum all = sumOf(left);
  const std::optional<BlockError> in_time = seriesError(left);
  const std::vector<BlockSum> groups = groupSums(species, cut);
  const bool grouped = groups.size() >= MIN_GROUPS;
  if (all.weight <= 0.0 || (!in_time && !grouped))
    return std::nullopt;
  SteadyMean mean;
  mean.estimate.value = all.sum / all.weight;
  if (in_time)
  {
    mean.estimate.half_width = halfWidthOver(confidence, in_time->blocks) * in_time->error;
    mean.times_for_trust = timesForTrust(left, *in_time);
  }
  if (grouped)
  {
    mean.estimate.half_width =
        std::max(mean.estimate.half_width, halfWidthOver(confidence, groups.size()) * scatterError(groups));
    mean.times_for_trust = BLOCKS_OF_GROUPS / static_cast<double>(left.size());
  }
  return mean;
}

/// The number of disks that left, and the fraction of them that left on the left.
struct Share
{
  explicit Share(const SpeciesBins& bins)
      : counted(static_cast<double>(bins.counted())), left(static_cast<double>(bins.left) / counted)
  {
  }

  double counted;
  double left;
};

/// For independent disks.
double countedHalfWidth(const Share& a, const Share& b, double confidence)
{
  const double z = halfWidthOver(confidence, 0);
  const auto [low_a, high_a] = wilsonInterval(a.left, a.counted, z);
  const auto [low_b, high_b] = wilsonInterval(b.left, b.counted, z);
  return std::max(std::hypot(a.left - low_a, high_b - b.left), std::hypot(high_a - a.left, b.left - low_b));
}

/// The difference of the fractions per block, relative to the overall one.
std::vector<BlockSum> deviations(const std::vector<BlockSum>& a, const std::vector<BlockSum>& b)
{
  const BlockSum all_a = sumOf(a);
  const BlockSum all_b = sumOf(b);
  std::vector<BlockSum> blocks;
  if (all_a.weight <= 0.0 || all_b.weight <= 0.0)
    return blocks;
  const auto deviation = [](const BlockSum& block, const BlockSum& all)
  { return (block.sum - all.sum / all.weight * block.weight) / all.weight; };
  for (std::size_t k = 0; k < a.size(); ++k)
    blocks.push_back({deviation(a[k], all_a) - deviation(b[k], all_b), 1.0 / static_cast<double>(a.size())});
  return blocks;
}

/// Largest change of the fraction by the disks still in the machine.
double open(const Share& share, const SpeciesBins& bins)
{
  const auto inside = static_cast<double>(bins.on_base);
  return inside / (share.counted + inside) * std::max(share.left, 1.0 - share.left);
}

}  // namespace

BlockSum sumOf(const std::vector<BlockSum>& blocks)
{
  BlockSum all;
  for (const BlockSum& block : blocks)
  {
    all.sum += block.sum;
    all.weight += block.weight;
  }
  return all;
}

double halfWidthOver(double confidence, std::size_t blocks)
{
  const double upper = 0.5 + 0.5 * confidence;
  if (blocks == 0)
    return quantile(boost::math::normal(), upper);
  return quantile(boost::math::students_t(static_cast<double>(blocks - 1)), upper);
}

double timesForTrust(const std::vector<BlockSum>& series, const BlockError& error)
{
  // Joining increases the error by the square root of the number of correlated blocks.
  const double joined = error.error > 0.0 ? std::max(1.0, error.error / scatterError(series)) : 1.0;
  return INDEPENDENT_BLOCKS / static_cast<double>(series.size()) * joined * joined;
}

std::size_t steadyFrom(const std::vector<BlockSum>& series)
{
  const std::size_t size = std::max<std::size_t>(1, series.size() / BATCHES);
  return size * leastErrorFrom(batchesOf(series, size));
}

SteadyMeans steadyMeans(const MeanSeries& series, double confidence)
{
  SteadyMeans means;
  means.of.resize(series.species.size());
  std::size_t blocks = 0;
  std::size_t cut = 0;
  for (const SpeciesSeries& species : series.species)
  {
    blocks = std::max(blocks, species.velocity.size());
    cut = std::max(cut, POINTS_CUT * steadyFrom(species.velocity));
  }
  if (blocks == 0 || 2 * cut > blocks)
    return means;
  means.transient = static_cast<double>(cut) * series.block_time;
  means.settled = CUTS_IN_A_RUN * cut <= blocks;
  means.left = static_cast<double>(blocks - cut) * series.block_time;
  for (std::size_t s = 0; s < means.of.size(); ++s)
    means.of[s] = meanAfter(series.species[s], cut, confidence);
  return means;
}

std::optional<SeparationEstimate> separationEstimate(const std::vector<SpeciesBins>& bins,
                                                     const std::vector<std::vector<BlockSum>>& exits,
                                                     double confidence)
{
  const PairSeparation pair = bestSeparation(bins);
  if (!pair.separation)
    return std::nullopt;
  const Share a(bins[pair.first]);
  const Share b(bins[pair.second]);
  SeparationEstimate found;
  found.sampled = countedHalfWidth(a, b, confidence);
  if (exits.empty())
  {
    const double rest = open(a, bins[pair.first]) + open(b, bins[pair.second]);
    found.estimate = {*pair.separation, found.sampled + rest};
    return found;
  }
  const std::vector<BlockSum> blocks = deviations(exits[pair.first], exits[pair.second]);
  const std::optional<BlockError> in_time = seriesError(blocks);
  if (!in_time)
    return std::nullopt;
  found.sampled = std::max(found.sampled, halfWidthOver(confidence, in_time->blocks) * in_time->error);
  found.times_for_trust = timesForTrust(blocks, *in_time);
  found.estimate = {*pair.separation, found.sampled};
  return found;
}

}  // namespace ratchet_sieve
