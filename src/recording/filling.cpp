#include "ratchet_sieve/recording/filling.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ratchet_sieve/recording/estimates.h"

namespace ratchet_sieve
{
namespace
{

/// After this many mean residence times an exponential approach is within 5 % of its end.
constexpr double RESIDENCES_TO_FILL = 3.0;

/// Number of cuts that are tried in a series.
constexpr std::size_t CUTS = 32;

/// The value that the Cramer-von Mises statistic of a Brownian bridge exceeds with a probability of 1 %: T.
/// W. Anderson and D. A. Darling, Ann. Math. Stat. 23, 193 (1952).
constexpr double LARGEST_STATISTIC = 0.74346;

/// A change of the mean from the second to the last quarter is told from noise at this many standard errors.
constexpr double CLEAR_CHANGE = 2.0;

/// Residence times that are looked for: at most this many lengths of the series, by so many halvings.
constexpr double LONGEST_STAY = 100.0;
constexpr int HALVINGS = 30;

/// The blocks less a straight line through their deviations from the mean.
std::vector<BlockSum> withoutTrend(std::vector<BlockSum> blocks)
{
  const BlockSum all = sumOf(blocks);
  const double middle = 0.5 * static_cast<double>(blocks.size() - 1);
  double products = 0.0;
  double squares = 0.0;
  for (std::size_t k = 0; k < blocks.size(); ++k)
  {
    const double age = static_cast<double>(k) - middle;
    products += (blocks[k].sum - all.sum / all.weight * blocks[k].weight) * age;
    squares += blocks[k].weight * age * age;
  }
  if (squares > 0.0)
    for (std::size_t k = 0; k < blocks.size(); ++k)
      blocks[k].sum -= products / squares * blocks[k].weight * (static_cast<double>(k) - middle);
  return blocks;
}

/// The squared error of the sum of the blocks, for each block, as of blocks without a trend; 0 if the series
/// does not tell it.
double noiseOf(const std::vector<BlockSum>& blocks)
{
  const std::optional<BlockError> found = seriesError(withoutTrend(blocks));
  const double error = found ? found->error * sumOf(blocks).weight : 0.0;
  return error * error / static_cast<double>(blocks.size());
}

/// @param noise as of noiseOf()
bool drifts(const std::vector<BlockSum>& blocks, double noise)
{
  const BlockSum all = sumOf(blocks);
  double sum = 0.0;
  double squares = 0.0;
  for (const BlockSum& block : blocks)
  {
    sum += block.sum - all.sum / all.weight * block.weight;
    squares += sum * sum;
  }
  const auto count = static_cast<double>(blocks.size());
  return squares > LARGEST_STATISTIC * noise * count * count;
}

/// One species, or all of them.
struct Flow
{
  std::vector<BlockSum> inside;  ///< as of SpeciesFlow
  std::vector<BlockSum> exits;   ///< as of leftShare()

  Flow from(std::size_t first) const { return {blocksFrom(inside, first), blocksFrom(exits, first)}; }

  /// The mean number inside over the throughput, as if one more had left: the throughput is not 0 [s].
  double residence() const { return sumOf(inside).sum / (sumOf(exits).weight + 1.0); }

  /// noiseOf() the number inside if disks are fed and move independently of each other: it is Poisson's, and
  /// its correlations decay within a residence time.
  double queueNoise() const
  {
    return 2.0 * residence() * sumOf(inside).sum / static_cast<double>(inside.size());
  }

  /// noiseOf() the exits if each disk leaves at either end independently of the others.
  double coinNoise() const
  {
    const BlockSum all = sumOf(exits);
    const double share = all.weight > 0.0 ? all.sum / all.weight : 0.0;
    return share * (1.0 - share) * all.weight / static_cast<double>(exits.size());
  }
};

/// Of its sum over the species.
Flow operator+(Flow a, const Flow& b)
{
  for (std::size_t k = 0; k < a.inside.size(); ++k)
  {
    a.inside[k].sum += b.inside[k].sum;
    a.exits[k].sum += b.exits[k].sum;
    a.exits[k].weight += b.exits[k].weight;
  }
  return a;
}

/// How clearly the number inside rises (above 0) or falls from the second to the last quarter of a series:
/// the change of its mean beyond what may be noise; 0: neither shows.
double clearChange(const Flow& flow)
{
  const std::size_t quarter = flow.inside.size() / 4;
  const auto of_quarter = [&](std::size_t k)
  {
    return sumOf({flow.inside.begin() + static_cast<std::ptrdiff_t>(k * quarter),
                  flow.inside.begin() + static_cast<std::ptrdiff_t>((k + 1) * quarter)});
  };
  const double change = of_quarter(3).sum - of_quarter(1).sum;
  const double noise = CLEAR_CHANGE * std::sqrt(2.0 * static_cast<double>(quarter) * flow.queueNoise());
  return std::copysign(std::max(std::abs(change) - noise, 0.0), change) / of_quarter(3).weight;
}

/// The residence time of a machine that fills as N (1 - exp(-t / τ)), at least: τ [s]. Then N is τ times the
/// rate of what comes in, and the rise from the second to the last quarter tells τ.
double leastResidence(const Flow& flow)
{
  const double length = sumOf(flow.inside).weight;
  const double rise = std::max(clearChange(flow), 0.0);
  const BlockSum last = flow.inside.back();
  const double rate = (sumOf(flow.exits).weight + last.sum / last.weight) / length;
  double low = 0.0;
  double high = LONGEST_STAY * length;
  for (int k = 0; k < HALVINGS; ++k)
  {
    const double stay = 0.5 * (low + high);
    const double left = std::exp(-0.25 * length / stay);
    const double expected = rate * stay * stay / (0.25 * length) * left * (1.0 - left) * (1.0 - left * left);
    (expected < rise ? low : high) = stay;
  }
  return low;
}

/// Searches the cut.
class Search
{
public:
  Search(const FlowSeries& series, const std::vector<std::string>& names) : series_(series), names_(names)
  {
    for (const SpeciesFlow& species : series.species)
      flows_.push_back({species.inside, leftShare(species.left.number, species.right.number)});
  }

  Filling found() const
  {
    const std::size_t count = flows_.front().inside.size();
    if (const double least = 2.0 * BlockAverages::MIN_BLOCKS * series_.block_time;
        count < 2 * BlockAverages::MIN_BLOCKS)
      return {std::nullopt, tooShort(least), least};
    std::size_t cut = 0;
    std::vector<Noise> noises;
    double needs = 0.0;
    for (const Flow& flow : flows_)
    {
      cut = std::max(cut, steadyFrom(flow.inside));
      const Flow half = flow.from(count / 2);
      noises.push_back({noiseOf(half.inside), noiseOf(half.exits)});
      needs = std::max(needs, 2.0 * RESIDENCES_TO_FILL * std::max(half.residence(), leastResidence(flow)));
    }
    std::string reason;
    for (; 2 * cut <= count; cut += std::max<std::size_t>(1, count / CUTS))
    {
      reason = whyNotFrom(cut, noises);
      if (reason.empty())
        return {cut, ""};
    }
    return {std::nullopt, reason, needs > end() - series_.start ? std::optional(needs) : std::nullopt};
  }

private:
  /// As seen, of one species.
  struct Noise
  {
    double inside;
    double exits;
  };

  double end() const
  {
    return series_.start + series_.block_time * static_cast<double>(flows_.front().inside.size());
  }

  std::string tooShort(double length) const
  {
    return fmt::format("too short: {:.3g} s, but {:.3g} s are needed to tell", end() - series_.start, length);
  }

  /// Why the machine has not filled at this cut; empty if it has.
  std::string whyNotFrom(std::size_t cut, const std::vector<Noise>& noises) const
  {
    for (std::size_t s = 0; s < flows_.size(); ++s)
    {
      const Flow rest = flows_[s].from(cut);
      const double needed = RESIDENCES_TO_FILL * rest.residence();
      if (static_cast<double>(cut) * series_.block_time < needed)
        return changeText(s, tooShort(2.0 * needed) + fmt::format(": {} stays {:.3g} s in the machine",
                                                                  names_[s], rest.residence()));
      if (drifts(rest.inside, std::max(noises[s].inside, rest.queueNoise())))
        return changeText(s, fmt::format("not settled: the number of {} inside drifts", names_[s]));
      if (drifts(rest.exits, std::max(noises[s].exits, rest.coinNoise())))
        return fmt::format("not settled: the share of {} that leaves to the left drifts", names_[s]);
    }
    return {};
  }

  /// In which direction the number inside changes, of all disks or of a species. @param otherwise if neither
  /// shows
  std::string changeText(std::size_t species, const std::string& otherwise) const
  {
    Flow all = flows_.front();
    for (std::size_t s = 1; s < flows_.size(); ++s)
      all = all + flows_[s];
    const BlockSum last = all.inside.back();
    const auto text = [&](double change, const std::string& of)
    {
      return fmt::format("still {}: {:.0f} inside after {:.0f} s{}{}", change > 0.0 ? "filling" : "emptying",
                         last.sum / last.weight, end(), of, change > 0.0 ? "rising" : "falling");
    };
    if (const double change = clearChange(all); change != 0.0)
      return text(change, " and ");
    if (const double change = clearChange(flows_[species]); change != 0.0)
      return text(change, ", " + names_[species] + " ");
    return otherwise;
  }

  const FlowSeries& series_;
  const std::vector<std::string>& names_;
  std::vector<Flow> flows_;  ///< per species
};

}  // namespace

Filling fillingOf(const FlowSeries& series, const std::vector<std::string>& names)
{
  return Search(series, names).found();
}

std::vector<BlockSum> blocksFrom(const std::vector<BlockSum>& blocks, std::size_t first)
{
  return {blocks.begin() + static_cast<std::ptrdiff_t>(first), blocks.end()};
}

std::vector<BlockSum> leftShare(const std::vector<BlockSum>& left, const std::vector<BlockSum>& right)
{
  std::vector<BlockSum> blocks;
  for (std::size_t k = 0; k < left.size(); ++k)
    blocks.push_back({left[k].sum, left[k].sum + right[k].sum});
  return blocks;
}

}  // namespace ratchet_sieve
