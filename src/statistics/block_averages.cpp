#include "ratchet_sieve/statistics/block_averages.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// At this number of blocks, neighbours are joined.
constexpr std::size_t MAX_BLOCKS = 512;

/// A series shorter than this many correlation times does not tell its error: most of what is left out is in
/// correlations that are longer than the series shows.
constexpr double SHORTEST_RUN = 6.0;

/// Wolff's S: how long the correlations are at most, over what is seen of them.
constexpr double WINDOW_FACTOR = 1.5;

/// Sums over a series stay within bounds, as displacements of trapped disks do, if those of sixteenths and of
/// quarters scatter by less than these shares of what independent blocks would. One in a hundred series of
/// independent blocks looks so.
constexpr double BOUNDED_SIXTEENTHS = 0.6;
constexpr double BOUNDED_QUARTERS = 0.2;

std::vector<BlockSum> joined(const std::vector<BlockSum>& blocks)
{
  std::vector<BlockSum> pairs;
  for (std::size_t i = 0; i + 1 < blocks.size(); i += 2)
    pairs.push_back({blocks[i].sum + blocks[i + 1].sum, blocks[i].weight + blocks[i + 1].weight});
  return pairs;
}
double weightOf(const std::vector<BlockSum>& blocks)
{
  double weight = 0.0;
  for (const BlockSum& block : blocks)
    weight += block.weight;
  return weight;
}

/// Of the blocks that have a weight: the sum less the ratio times the weight.
std::vector<double> deviationsOf(const std::vector<BlockSum>& blocks)
{
  double sum = 0.0;
  for (const BlockSum& block : blocks)
    sum += block.sum;
  const double weight = weightOf(blocks);
  std::vector<double> deviations;
  for (const BlockSum& block : blocks)
    if (block.weight > 0.0)
      deviations.push_back(block.sum - sum / weight * block.weight);
  return deviations;
}

/// The sum of the products of deviations that are `lag` blocks apart.
double lagSum(const std::vector<double>& deviations, std::size_t lag)
{
  double sum = 0.0;
  for (std::size_t k = lag; k < deviations.size(); ++k)
    sum += deviations[k] * deviations[k - lag];
  return sum;
}

/// The mean square of the sums of `length` consecutive deviations.
double spread(const std::vector<double>& deviations, std::size_t length)
{
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < deviations.size(); ++k)
  {
    sum += deviations[k] - (k >= length ? deviations[k - length] : 0.0);
    squares += k + 1 >= length ? sum * sum : 0.0;
  }
  return squares / static_cast<double>(deviations.size() - length + 1);
}

/// The squared error of the sum of a series whose sums stay within bounds: the spread of quarters, and as
/// much more for the rest as it grows between eighths and quarters; nothing if they do not.
/// @param independent sum of the squares
std::optional<double> boundedSquare(const std::vector<double>& deviations, double independent)
{
  const std::size_t eighth = deviations.size() / 8;
  const double quarters = spread(deviations, 2 * eighth);
  if (16.0 * spread(deviations, eighth / 2) >= BOUNDED_SIXTEENTHS * independent ||
      4.0 * quarters >= BOUNDED_QUARTERS * independent)
    return std::nullopt;
  const double growth = std::max(0.0, quarters - spread(deviations, eighth)) / static_cast<double>(eighth);
  return quarters + growth * static_cast<double>(deviations.size() - 2 * eighth);
}

/// Whether a longer window would add more noise to the error than it removes bias from it: Wolff's eq. 52.
/// @param correlated correlation time seen in the window, in blocks: twice the integrated autocorrelation
/// time
bool windowEnds(double correlated, std::size_t lag, std::size_t count)
{
  if (correlated <= 1.0)
    return true;
  const double decay = WINDOW_FACTOR / std::log((correlated + 1.0) / (correlated - 1.0));
  const auto window = static_cast<double>(lag);
  return std::exp(-window / decay) < decay / std::sqrt(window * static_cast<double>(count));
}
}  // namespace

void BlockAverages::add(double displacement, double time)
{
  open_.sum += displacement;
  open_.weight += time;
  if (++samples_ < block_length_)
    return;
  blocks_.push_back(open_);
  open_ = BlockSum();
  samples_ = 0;
  if (blocks_.size() < MAX_BLOCKS)
    return;
  blocks_ = joined(blocks_);
  block_length_ *= 2;
}

double scatterError(const std::vector<BlockSum>& blocks)
{
  const std::vector<double> deviations = deviationsOf(blocks);
  if (deviations.empty())
    return 0.0;
  const auto count = static_cast<double>(deviations.size());
  return std::sqrt(lagSum(deviations, 0) * count / (count - 1.0)) / weightOf(blocks);
}

std::optional<BlockError> seriesError(const std::vector<BlockSum>& blocks)
{
  const std::vector<double> deviations = deviationsOf(blocks);
  const std::size_t count = deviations.size();
  if (count < BlockAverages::MIN_BLOCKS)
    return std::nullopt;
  const double independent = lagSum(deviations, 0);
  if (independent <= 0.0)
    return BlockError{0.0, count};
  if (const std::optional<double> squared = boundedSquare(deviations, independent))
    return BlockError{std::sqrt(*squared) / weightOf(blocks), 4};
  double sum = independent;
  for (std::size_t lag = 1; 2 * lag + 1 < count / 2; ++lag)
  {
    sum += 2.0 * lagSum(deviations, lag);
    if (!windowEnds(sum / independent, lag, count))
      continue;
    const double blocks_in_window = static_cast<double>(count) / static_cast<double>(2 * lag + 1);
    // Deviations are from the series' own mean, which makes their products too small.
    const double squared = std::max(sum, independent) / (1.0 - 1.0 / blocks_in_window);
    if (squared * SHORTEST_RUN > static_cast<double>(count) * independent)
      return std::nullopt;
    return BlockError{std::sqrt(squared) / weightOf(blocks), 1 + static_cast<std::size_t>(blocks_in_window)};
  }
  return std::nullopt;
}

}  // namespace ratchet_sieve
