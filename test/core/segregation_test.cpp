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
}

TEST(BinShares, AddUpToOneAndToQ)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const auto count = rc::gen::inRange<std::uint64_t>(0, 50);
        std::vector<SpeciesBins> bins(2);
        for (SpeciesBins& b : bins)
        {
          b = {*count, *count, *count};
          b.left_mass = 0.01 * static_cast<double>(b.left);
          b.right_mass = 0.01 * static_cast<double>(b.right);
          RC_PRE(b.counted() > 0);
        }
        const std::vector<SpeciesShares> shares = binShares(bins);
        for (const auto share : {&BinShares::number, &BinShares::mass})
        {
          for (const auto bin : {&SpeciesShares::left, &SpeciesShares::right})
            if ((shares[0].*bin.*share).purity)
              RC_ASSERT(std::abs(*(shares[0].*bin.*share).purity + *(shares[1].*bin.*share).purity - 1.0) <
                        1e-12);
          for (const SpeciesShares& species : shares)
            RC_ASSERT(std::abs(*(species.left.*share).recovery + *(species.right.*share).recovery - 1.0) <
                      1e-12);
        }
        const double q = *shares[0].left.number.recovery + *shares[1].right.number.recovery - 1.0;
        RC_ASSERT(std::abs(std::abs(q) - *segregationQuality(bins[0], bins[1])) < 1e-12);
      }));
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
