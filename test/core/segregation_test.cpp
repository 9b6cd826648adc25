#include "ratchet_sieve/statistics/segregation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "ratchet_sieve/core/collision_counts.h"

namespace ratchet_sieve
{
namespace
{

PairSeparation pairOf(const SpeciesBins& a, const SpeciesBins& b)
{
  return pairSeparations({a, b}).front();
}

/// Q as eq. (2) of the paper has it.
double printedQuality(const SpeciesBins& a, const SpeciesBins& b)
{
  const auto share = [](std::uint64_t part, const SpeciesBins& of)
  { return static_cast<double>(part) / static_cast<double>(of.counted()); };
  return std::max(share(a.left, a) + share(b.right, b), share(a.right, a) + share(b.left, b)) - 1.0;
}

TEST(Separation, KnownAnswers)
{
  EXPECT_DOUBLE_EQ(*pairOf({10, 0, 0}, {0, 5, 3}).separation, 1.0);
  EXPECT_DOUBLE_EQ(*pairOf({0, 10, 0}, {5, 0, 0}).separation, -1.0);
  EXPECT_DOUBLE_EQ(*pairOf({0, 10, 0}, {5, 0, 0}).quality(), 1.0);
  EXPECT_DOUBLE_EQ(*pairOf({5, 5, 0}, {2, 2, 0}).separation, 0.0);
  EXPECT_DOUBLE_EQ(*pairOf({3, 1, 0}, {1, 3, 0}).separation, 0.5);
  // Large disks of A on the left, small ones on the right.
  EXPECT_DOUBLE_EQ(*pairOf({1, 1, 0, 0.09, 0.01}, {1, 1, 0, 0.01, 0.01}).by_mass, 0.4);
}

TEST(Separation, IsUndefinedUntilEachSpeciesWasCounted)
{
  EXPECT_FALSE(pairOf({0, 0, 9}, {1, 2, 0}).separation);
  EXPECT_FALSE(pairOf({4, 0, 9}, {0, 0, 1}).quality());
  EXPECT_FALSE(bestSeparation({{1, 2, 3}}).quality());
}

TEST(Separation, HasThePrintedQualityAsItsSizeAndTurnsWithTheSidesAndTheSpecies)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const auto count = rc::gen::inRange<std::uint64_t>(0, 50);
        const SpeciesBins a{*count, *count, *count};
        const SpeciesBins b{*count, *count, *count};
        RC_PRE(a.counted() > 0 && b.counted() > 0);
        const PairSeparation pair = pairOf(a, b);
        RC_ASSERT(*pair.quality() <= 1.0);
        RC_ASSERT(std::abs(*pair.quality() - printedQuality(a, b)) <= 1e-15);
        RC_ASSERT(*pairOf(b, a).separation == -*pair.separation);
        const double mirrored = *pairOf({a.right, a.left, 0}, {b.right, b.left, 0}).separation;
        RC_ASSERT(std::abs(mirrored + *pair.separation) <= 1e-15);
      }));
}

TEST(Separation, OfThreeSpeciesInOrderAndTheBest)
{
  const std::vector<SpeciesBins> bins{{10, 0, 0}, {0, 10, 0}, {5, 5, 0}};
  const auto pairs = pairSeparations(bins);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[1].first, 0u);
  EXPECT_EQ(pairs[1].second, 2u);
  EXPECT_DOUBLE_EQ(*pairs[1].separation, 0.5);
  EXPECT_DOUBLE_EQ(*bestSeparation(bins).separation, 1.0);
}

TEST(ProcessedRatio, CountedOverAll)
{
  EXPECT_FALSE(processedRatio({{0, 0, 5}, {0, 0, 5}}));
  EXPECT_DOUBLE_EQ(*processedRatio({{1, 2, 1}, {0, 0, 4}}), 3.0 / 8.0);
}

TEST(BinShares, AreUndefinedOfEmptyBinsAndOfSpeciesOfWhichNothingLeft)
{
  const std::vector<SpeciesShares> none = binShares({{0, 0, 5}, {0, 0, 5}});
  EXPECT_FALSE(none[0].left.number.purity);
  EXPECT_FALSE(none[1].right.mass.recovery);
  const std::vector<SpeciesShares> some = binShares({{3, 0, 5, 0.3, 0.0}, {0, 0, 5}});
  EXPECT_EQ(some[0].left.number.purity, 1.0);
  EXPECT_EQ(some[0].left.mass.recovery, 1.0);
  EXPECT_EQ(some[0].right.number.recovery, 0.0);
  EXPECT_FALSE(some[0].right.number.purity);
  EXPECT_EQ(some[1].left.number.purity, 0.0);
  EXPECT_FALSE(some[1].left.number.recovery);
}

TEST(BinShares, OfAHeavyAndALightSpecies)
{
  // Of A 3 left and 1 right of 10 g each, of B 1 left and 1 right of 1 g each.
  const std::vector<SpeciesShares> shares = binShares({{3, 1, 0, 0.03, 0.01}, {1, 1, 0, 0.001, 0.001}});
  EXPECT_DOUBLE_EQ(*shares[0].left.number.purity, 0.75);
  EXPECT_DOUBLE_EQ(*shares[0].left.mass.purity, 30.0 / 31.0);
  EXPECT_DOUBLE_EQ(*shares[0].right.number.recovery, 0.25);
  EXPECT_DOUBLE_EQ(*shares[0].right.mass.recovery, 0.25);
  EXPECT_DOUBLE_EQ(*shares[1].right.mass.purity, 1.0 / 11.0);
  EXPECT_DOUBLE_EQ(*shares[0].right.mass.recovery, 0.25);
  EXPECT_DOUBLE_EQ(*shares[1].left.number.recovery, 0.5);
}

TEST(CollisionCounts, ShortToLongFollowsTheAsymmetry)
{
  CollisionCounts counts;
  EXPECT_FALSE(counts.shortToLong(0.3));
  counts.left_slope = 1;
  counts.right_slope = 2;
  EXPECT_DOUBLE_EQ(*counts.shortToLong(0.3), 0.5);
  EXPECT_DOUBLE_EQ(*counts.shortToLong(0.7), 2.0);
  EXPECT_FALSE(counts.shortToLong(0.5));
}

}  // namespace
}  // namespace ratchet_sieve
