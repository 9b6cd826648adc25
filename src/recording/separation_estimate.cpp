#include "ratchet_sieve/recording/separation_estimate.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{

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

/// Distances of the ends of Wilson's interval below and above a proportion.
struct Margins
{
  double below;
  double above;
};

Margins wilson(const Share& share, double z)
{
  const double n = share.counted;
  const double centre = (share.left + z * z / (2.0 * n)) / (1.0 + z * z / n);
  const double half =
      z / (1.0 + z * z / n) * std::sqrt(share.left * (1.0 - share.left) / n + z * z / (4.0 * n * n));
  return {share.left - centre + half, centre + half - share.left};
}

/// For independent disks.
double countedHalfWidth(const Share& a, const Share& b, double confidence)
{
  const double z = halfWidthOver(confidence, 0);
  const Margins of_a = wilson(a, z);
  const Margins of_b = wilson(b, z);
  return std::max(std::hypot(of_a.below, of_b.above), std::hypot(of_a.above, of_b.below));
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
