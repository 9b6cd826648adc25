#include "ratchet_sieve/seeking/separation.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace ratchet_sieve
{
namespace
{
SpeciesBins fallen(std::uint64_t left, std::uint64_t right)
{
  return {left, right, 0};
}

Score scoreOf(const std::vector<SpeciesBins>& bins)
{
  return scoreOf(Outflow{std::vector<std::string>(bins.size()), bins, 10.0});
}

TEST(Score, isThePapersQualityWithItsError)
{
  const Score score = scoreOf({fallen(10, 90), fallen(70, 30)});
  EXPECT_TRUE(score.quality.defined);
  EXPECT_NEAR(score.quality.value, 0.6, 1e-12);
  // Binomial: 0.9 * 0.1 / 100 + 0.7 * 0.3 / 100, and a little more because of Laplace's rule.
  EXPECT_NEAR(score.quality.error, std::sqrt((0.09 + 0.21) / 100.0), 0.002);
  EXPECT_NEAR(score.balance, (0.8 - 0.4) / 2.0, 1e-12);
}

TEST(Score, ofAllToOneSideIsStillInDoubt)
{
  const Score score = scoreOf({fallen(0, 10), fallen(0, 10)});
  EXPECT_EQ(score.quality.value, 0.0);
  EXPECT_GT(score.quality.error, 0.05);
  EXPECT_EQ(score.balance, 1.0);
}

TEST(Score, isUndefinedWhereASpeciesIsKeptBack)
{
  const Score score = scoreOf({fallen(0, 0), fallen(70, 30)});
  EXPECT_FALSE(score.quality.defined);
  EXPECT_EQ(score.quality.value, 0.0);
  EXPECT_NEAR(score.balance, -0.4, 1e-12);
  EXPECT_EQ(scoreOf({}).balance, 0.0);
}

TEST(Score, ofSeveralSpeciesIsThatOfTheBestPair)
{
  const Score score = scoreOf({fallen(50, 50), fallen(45, 55), fallen(0, 100)});
  EXPECT_NEAR(score.quality.value, 0.5, 1e-12);
}

RC_GTEST_PROP(Score, partsWhatGoesOneWayFromWhatGoesTwo, ())
{
  const auto some = [] { return *rc::gen::inRange<std::uint64_t>(0, 50); };
  const Score score = scoreOf({fallen(some(), some() + 1), fallen(some() + 1, some())});
  RC_ASSERT(std::abs(score.balance) + score.quality.value <= 1.0 + 1e-12);
  RC_ASSERT(score.quality.error > 0.0);
}

RC_GTEST_PROP(Score, ofAllThatLeftGrowsSurer, ())
{
  const auto some = [] { return *rc::gen::inRange<std::uint64_t>(1, 50); };
  const Outflow once{{"A", "B"}, {fallen(some(), some()), fallen(some(), some())}, 10.0};
  Outflow sum;
  sum.add(once);
  RC_ASSERT(scoreOf(sum).quality.error == scoreOf(once).quality.error);
  sum.add(once);
  RC_ASSERT(std::abs(scoreOf(sum).quality.value - scoreOf(once).quality.value) < 1e-12);
  RC_ASSERT(scoreOf(sum).quality.error < scoreOf(once).quality.error);
}
}  // namespace
}  // namespace ratchet_sieve
