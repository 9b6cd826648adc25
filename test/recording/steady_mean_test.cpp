// An interval contains the true value as often as it claims, for series with a known mean.
#include "ratchet_sieve/recording/estimates.h"

#include <gtest/gtest.h>

#include "coverage.h"
#include "series_draws.h"

namespace ratchet_sieve
{
namespace
{

using Shape = CorrelatedSeries::Shape;

constexpr int SEEDS = 300;

MeanSeries seriesOf(const BlockAverages& blocks)
{
  MeanSeries series;
  series.block_time = static_cast<double>(blocks.blockLength());
  series.species.push_back({blocks.blocks(), {}, {}});
  return series;
}

/// The half-width of a known error after this number of samples.
double halfWidthAfter(double samples, double memory, double confidence)
{
  return halfWidthOver(confidence, 0) * std::sqrt((1.0 + memory) / (1.0 - memory) / samples);
}

/// Parts of the rule that can be switched off.
struct Rule
{
  bool cut = true;
  bool joined = true;
};

/// The steady part's mean, reliable or not.
std::optional<SteadyMean> meanBy(const Rule& rule, const BlockAverages& blocks, double confidence)
{
  if (rule.cut && rule.joined)
  {
    const SteadyMeans means = steadyMeans(seriesOf(blocks), confidence);
    return means.settled ? means.of[0] : std::nullopt;
  }
  const std::size_t from = rule.cut ? 2 * steadyFrom(blocks.blocks()) : 0;
  if (blocks.blocks().size() < 10 * from + BlockAverages::MIN_BLOCKS)
    return std::nullopt;
  const std::vector<BlockSum> left(blocks.blocks().begin() + static_cast<std::ptrdiff_t>(from),
                                   blocks.blocks().end());
  const BlockError error = rule.joined ? *seriesError(left) : BlockError{scatterError(left), left.size()};
  const BlockSum all = sumOf(left);
  return SteadyMean{{all.sum / all.weight, halfWidthOver(confidence, error.blocks) * error.error},
                    timesForTrust(left, error)};
}

struct End
{
  Estimate estimate;
  std::size_t samples = 0;
};

/// The end of a series that is checked at the times of a run (LookTimes).
End endOf(const Shape& shape, std::uint64_t seed, double confidence, double wanted, const Rule& rule)
{
  CorrelatedSeries series(shape, seed);
  for (std::size_t samples = 32;; samples += (samples + 4) / 5)
  {
    series.extendTo(samples);
    const std::optional<SteadyMean> mean = meanBy(rule, series.blocks(), confidence);
    if (mean && mean->times_for_trust <= 1.0 && mean->estimate.half_width <= wanted)
      return {mean->estimate, samples};
  }
}

struct Ends
{
  Coverage coverage;
  double samples = 0.0;  ///< mean
};

Ends endsOf(const Shape& shape, double confidence, double samples, const Rule& rule = {})
{
  Ends ends;
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed)
  {
    const End end = endOf(shape, seed, confidence, halfWidthAfter(samples, shape.memory, confidence), rule);
    ends.coverage.take(std::abs(end.estimate.value - shape.mean) <= end.estimate.half_width);
    ends.samples += static_cast<double>(end.samples) / SEEDS;
  }
  return ends;
}

void expectAsClaimed(const Shape& shape, double confidence, double samples)
{
  const Coverage coverage = endsOf(shape, confidence, samples).coverage;
  EXPECT_NEAR(coverage.share(), confidence, coverage.tolerance(confidence))
      << "memory " << shape.memory << ", transient " << shape.transient << ", " << samples << " samples";
}

TEST(SteadyMean, HoldsTheTruthAsOftenAsItClaims)
{
  for (const double confidence : {0.8, 0.95})
    for (const double memory : {0.0, 0.8})
      for (const double transient : {0.0, 3.0})
        expectAsClaimed({2.0, memory, transient}, confidence, 3000.0);
}

TEST(SteadyMean, HoldsTheTruthWhereTheFirstHalfWidthsWouldDo)
{
  // A wide interval is reached long before the correlation and the transient are detected.
  expectAsClaimed({2.0, 0.9, 0.0}, 0.8, 50.0);
  expectAsClaimed({2.0, 0.0, 3.0}, 0.8, 300.0);
  expectAsClaimed({2.0, 0.0, 0.5, 400.0}, 0.8, 3000.0);
}

TEST(SteadyMean, HoldsItByTheCutAndByTheJoinedBlocks)
{
  const Shape transient{2.0, 0.0, 0.5, 400.0};
  const Shape correlated{2.0, 0.8, 0.0};
  EXPECT_LT(endsOf(transient, 0.95, 3000.0, {false, false}).coverage.share(), 0.2);
  EXPECT_LT(endsOf(correlated, 0.95, 1000.0, {true, false}).coverage.share(), 0.7);
  // Joined blocks include the transient as well; without the cut, a run needs to be longer.
  const Shape brief{2.0, 0.0, 3.0, 50.0};
  EXPECT_GT(endsOf(brief, 0.95, 3000.0, {false, true}).samples, 1.5 * endsOf(brief, 0.95, 3000.0).samples);
}

TEST(SteadyMean, FindsWhereATransientEnds)
{
  // A step: none of its blocks is left, and few more are cut.
  std::vector<BlockSum> series;
  for (int k = 0; k < 400; ++k)
    series.push_back({k < 60 ? 5.0 : 1.0 + 0.1 * (k % 2), 1.0});
  EXPECT_EQ(steadyFrom(series), 60u);
  for (BlockSum& block : series)
    block.sum = 1.0 + 0.1 * (block.sum > 1.05);
  EXPECT_LE(steadyFrom({series.begin() + 60, series.end()}), 1u);
}

TEST(SteadyMean, WeighsABlockByItsWeight)
{
  // The same velocity with fewer and fewer disks is no transient; neither is another velocity of no disks.
  std::vector<BlockSum> series;
  for (int k = 0; k < 200; ++k)
  {
    const double weight = 200.0 - k;
    series.push_back({weight * (1.0 + (k % 2 == 0 ? 0.01 : -0.01)), weight});
  }
  EXPECT_LT(steadyFrom(series), 10u);
  EXPECT_EQ(steadyFrom({}), 0u);
  EXPECT_EQ(steadyFrom({{0.0, 0.0}, {0.0, 0.0}}), 0u);
}

TEST(SteadyMean, OfAMachineThatHasEmptiedSaysNothing)
{
  for (const int there : {1, 10, 15})
  {
    MeanSeries series;
    series.block_time = 1.0;
    series.species.resize(1);
    for (int k = 0; k < 300; ++k)
      series.species[0].velocity.push_back(k < there ? BlockSum{1.0 + 0.01 * (k % 2), 1.0} : BlockSum{});
    EXPECT_FALSE(steadyMeans(series, 0.95).of[0]) << there;
  }
}

TEST(SteadyMean, OfATransientThatLastsSaysNothing)
{
  MeanSeries series;
  series.block_time = 1.0;
  series.species.resize(1);
  for (int k = 0; k < 100; ++k)
    series.species[0].velocity.push_back({k < 40 ? 1.0 : 0.01 * (k % 3), 1.0});
  const SteadyMeans means = steadyMeans(series, 0.95);
  EXPECT_FALSE(means.transient);
  EXPECT_FALSE(means.settled);
  EXPECT_FALSE(means.of[0]);
}

TEST(SteadyMean, OfGroupsHasTheErrorOfTheirScatter)
{
  // Groups with constant, different velocities: their sum is constant in time.
  MeanSeries series;
  series.block_time = 1.0;
  series.species.resize(1);
  SpeciesSeries& species = series.species[0];
  for (int g = 0; g < 32; ++g)
    species.groups.push_back(std::vector<BlockSum>(64, BlockSum{g % 2 == 0 ? 1.0 : -1.0, 1.0}));
  species.velocity.assign(64, {0.0, 32.0});
  const SteadyMeans means = steadyMeans(series, 0.95);
  ASSERT_TRUE(means.of[0]);
  EXPECT_EQ(means.of[0]->estimate.value, 0.0);
  EXPECT_NEAR(means.of[0]->estimate.half_width, halfWidthOver(0.95, 32) / std::sqrt(31.0), 1e-12);
  EXPECT_LE(means.of[0]->times_for_trust, 1.0);
}

TEST(SteadyMean, TakesItsQuantilesFromTables)
{
  // Abramowitz & Stegun, table 26.10, and 1.96.
  EXPECT_NEAR(halfWidthOver(0.95, 11), 2.228, 5e-4);
  EXPECT_NEAR(halfWidthOver(0.8, 16), 1.341, 5e-4);
  EXPECT_NEAR(halfWidthOver(0.95, 0), 1.959964, 1e-6);
}

}  // namespace
}  // namespace ratchet_sieve
