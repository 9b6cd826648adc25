// An interval contains the true value as often as it claims, for series with a known mean.
#include "ratchet_sieve/recording/estimates.h"

#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "coverage.h"
#include "ratchet_sieve/statistics/block_averages.h"

namespace ratchet_sieve
{
namespace
{

/// x[k] = memory x[k-1] + noise, with variance 1 about a mean, and a transient that decays: a series with
/// known properties. In blocks, as a run's. Uses the generator's bits only, because the library's
/// distributions differ between implementations.
class CorrelatedSeries
{
public:
  struct Shape
  {
    double mean = 2.0;
    double memory = 0.0;     ///< correlation of neighbouring samples
    double transient = 0.0;  ///< at the first sample
    double decay = 50.0;     ///< of the transient [samples]
  };

  CorrelatedSeries(const Shape& shape, std::uint64_t seed) : shape_(shape), bits_(seed), value_(normal()) {}

  /// Adds samples up to this number.
  void extendTo(std::size_t samples)
  {
    for (; samples_ < samples; ++samples_)
    {
      const double age = static_cast<double>(samples_) / shape_.decay;
      blocks_.add(shape_.mean + shape_.transient * std::exp(-age) + value_, 1.0);
      value_ = shape_.memory * value_ + std::sqrt(1.0 - shape_.memory * shape_.memory) * normal();
    }
  }

  const BlockAverages& blocks() const { return blocks_; }

private:
  double uniform() { return (static_cast<double>(bits_() >> 11) + 0.5) * 0x1p-53; }
  double normal() { return std::sqrt(-2.0 * std::log(uniform())) * std::cos(6.283185307179586 * uniform()); }

  Shape shape_;
  std::mt19937_64 bits_;
  BlockAverages blocks_;
  double value_;
  std::size_t samples_ = 0;
};

using Shape = CorrelatedSeries::Shape;

constexpr int SEEDS = 300;

MeanSeries seriesOf(const BlockAverages& blocks)
{
  MeanSeries series;
  series.block_time = static_cast<double>(blocks.blockLength());
  series.species.push_back({blocks.blocks(), {}});
  return series;
}

/// The half-width of a known error after this number of samples.
double halfWidthAfter(double samples, double memory, double confidence)
{
  return halfWidthOver(confidence, 0) * std::sqrt((1.0 + memory) / (1.0 - memory) / samples);
}

/// The mean at the end of a series that is checked at the times of a run (lookFrom()).
Estimate endOf(const Shape& shape, std::uint64_t seed, double confidence, double wanted)
{
  CorrelatedSeries series(shape, seed);
  for (std::size_t samples = 32;; samples += (samples + 4) / 5)
  {
    series.extendTo(samples);
    const SteadyMeans means = steadyMeans(seriesOf(series.blocks()), confidence);
    const std::optional<SteadyMean>& mean = means.of[0];
    if (means.settled && mean && mean->times_for_trust <= 1.0 && mean->estimate.half_width <= wanted)
      return mean->estimate;
  }
}

void expectAsClaimed(const Shape& shape, double confidence, double samples)
{
  Coverage coverage;
  for (std::uint64_t seed = 1; seed <= SEEDS; ++seed)
  {
    const Estimate end = endOf(shape, seed, confidence, halfWidthAfter(samples, shape.memory, confidence));
    coverage.take(std::abs(end.value - shape.mean) <= end.half_width);
  }
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

TEST(SeparationEstimate, IsOfTheIntervalThatNewcombePrints)
{
  // Stat. Med. 17, 873 (1998), table II: 56 of 70 and 48 of 80, method 10: 0.2 in [0.0524, 0.3339].
  const auto found = separationEstimate({{56, 14, 0}, {48, 32, 0}}, {}, 0.95);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->estimate.value, 0.2, 1e-12);
  EXPECT_NEAR(found->estimate.half_width, 0.2 - 0.0524, 1e-4);
  // 10 of 10 and 0 of 10: 1 in [0.6075, 1]. The error from the variance of the counts would be 0.
  EXPECT_NEAR(separationEstimate({{10, 0, 0}, {0, 10, 0}}, {}, 0.95)->estimate.half_width, 1.0 - 0.6075,
              1e-4);
}

TEST(SeparationEstimate, IsNoneWhileSIsNone)
{
  EXPECT_FALSE(separationEstimate({{3, 1, 2}, {0, 0, 4}}, {}, 0.95));
  EXPECT_FALSE(separationEstimate({{3, 1, 2}}, {}, 0.95));
}

TEST(SeparationEstimate, IsWidenedByWhatTheRestCouldChange)
{
  const double counted = separationEstimate({{30, 10, 0}, {10, 30, 0}}, {}, 0.95)->estimate.half_width;
  const auto found = separationEstimate({{30, 10, 10}, {10, 30, 0}}, {}, 0.95);
  EXPECT_NEAR(found->sampled, counted, 1e-12);
  // Ten more of A on the right: 30 of 50 instead of 30 of 40.
  EXPECT_NEAR(found->estimate.half_width, counted + 0.75 - 0.6, 1e-12);
}

TEST(SeparationEstimate, OfDisksThatLeaveTogetherHasTheErrorOfTheCourse)
{
  // Groups of ten that leave on the same side: the information of a tenth of the disks.
  std::mt19937_64 bits(3);
  std::vector<std::vector<BlockSum>> exits(2);
  std::vector<SpeciesBins> bins(2);
  for (int k = 0; k < 400; ++k)
    for (int s = 0; s < 2; ++s)
    {
      const std::uint64_t left = bits() >> 63 != 0 ? 10 : 0;
      exits[s].push_back({static_cast<double>(left), 10.0});
      bins[s].left += left;
      bins[s].right += 10 - left;
    }
  const double expected = halfWidthOver(0.95, 0) * std::sqrt(2.0 * 0.25 / 400.0);
  const auto found = separationEstimate(bins, exits, 0.95);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->estimate.half_width, expected, 0.35 * expected);
  EXPECT_LE(found->times_for_trust, 1.0);
  EXPECT_NEAR(separationEstimate(bins, {}, 0.95)->estimate.half_width, expected / std::sqrt(10.0),
              0.05 * expected);
}

TEST(SeparationEstimate, HoldsTheTruthAsOftenAsItClaims)
{
  std::mt19937_64 bits(7);
  const auto drawn = [&bits](int of, double share)
  {
    SpeciesBins bins;
    for (int k = 0; k < of; ++k)
      ++(static_cast<double>(bits() >> 11) * 0x1p-53 < share ? bins.left : bins.right);
    return bins;
  };
  for (const double confidence : {0.8, 0.95})
  {
    Coverage coverage;
    for (int k = 0; k < 1000; ++k)
    {
      const auto found = separationEstimate({drawn(40, 0.9), drawn(60, 0.2)}, {}, confidence);
      coverage.take(std::abs(found->estimate.value - 0.7) <= found->estimate.half_width);
    }
    EXPECT_GE(coverage.share(), confidence - coverage.tolerance(confidence));
    // The larger margin of an asymmetric interval is used for both.
    EXPECT_LE(coverage.share(), 0.5 + 0.5 * confidence);
  }
}

}  // namespace
}  // namespace ratchet_sieve
