#include "ratchet_sieve/core/segregation.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "ratchet_sieve/core/collision_counts.h"

namespace ratchet_sieve
{
namespace
{

TEST(SegregationQuality, KnownAnswers)
{
  EXPECT_DOUBLE_EQ(*segregationQuality({10, 0, 0}, {0, 5, 3}), 1.0);
  EXPECT_DOUBLE_EQ(*segregationQuality({0, 10, 0}, {5, 0, 0}), 1.0);
  EXPECT_DOUBLE_EQ(*segregationQuality({5, 5, 0}, {2, 2, 0}), 0.0);
  EXPECT_DOUBLE_EQ(*segregationQuality({3, 1, 0}, {1, 3, 0}), 0.5);
}

TEST(SegregationQuality, UndefinedUntilEachSpeciesWasCounted)
{
  EXPECT_FALSE(segregationQuality({0, 0, 9}, {1, 2, 0}));
  EXPECT_FALSE(segregationQuality({4, 0, 9}, {0, 0, 1}));
  EXPECT_FALSE(bestQuality({{1, 2, 3}}));
}

TEST(SegregationQuality, LiesInTheUnitIntervalAndDoesNotCareWhichSideIsWhich)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const auto count = rc::gen::inRange<std::uint64_t>(0, 50);
        const SpeciesBins a{*count, *count, *count};
        const SpeciesBins b{*count, *count, *count};
        RC_PRE(a.counted() > 0 && b.counted() > 0);
        const double q = *segregationQuality(a, b);
        RC_ASSERT(q >= -1e-15);
        RC_ASSERT(q <= 1.0);
        RC_ASSERT(*segregationQuality({a.right, a.left, 0}, {b.right, b.left, 0}) == q);
        RC_ASSERT(*segregationQuality(b, a) == q);
      }));
}

TEST(PairQualities, OfThreeSpeciesInOrderAndTheBest)
{
  const std::vector<SpeciesBins> bins{{10, 0, 0}, {0, 10, 0}, {5, 5, 0}};
  const auto pairs = pairQualities(bins);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[1].first, 0u);
  EXPECT_EQ(pairs[1].second, 2u);
  EXPECT_DOUBLE_EQ(*pairs[1].quality, 0.5);
  EXPECT_DOUBLE_EQ(*bestQuality(bins), 1.0);
}

TEST(ProcessedRatio, CountedOverAll)
{
  EXPECT_FALSE(processedRatio({{0, 0, 5}, {0, 0, 5}}));
  EXPECT_DOUBLE_EQ(*processedRatio({{1, 2, 1}, {0, 0, 4}}), 3.0 / 8.0);
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
