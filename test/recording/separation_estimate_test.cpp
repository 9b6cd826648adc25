#include "ratchet_sieve/recording/estimates.h"

#include <random>

#include <gtest/gtest.h>

#include "coverage.h"

namespace ratchet_sieve
{
namespace
{

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
