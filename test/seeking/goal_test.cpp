#include "ratchet_sieve/seeking/goal.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "ratchet_sieve/seeking/separation.h"

namespace ratchet_sieve
{
namespace
{
/// In 20 s 30 of A (10 g) and 10 of B (1 g) fell to the left, 20 of A and 40 of B to the right.
Outflow known()
{
  return {{"A", "B"}, {{30, 20, 5, 0.3, 0.2}, {10, 40, 6, 0.01, 0.04}}, 20.0};
}

Measured of(const std::string& text, const Outflow& outflow)
{
  return measured(*goalFromText(text), outflow);
}

TEST(Goal, IsReadAndWritten)
{
  for (const char* text :
       {"quality", "purity:A:left", "recovery:B:right", "recovery:B:right:mass", "flow:A:left", "throughput",
        "throughput:mass", "purity:fine: dust:left", "purity:mass:right"})
  {
    ASSERT_TRUE(goalFromText(text)) << text;
    EXPECT_EQ(goalText(*goalFromText(text)), text);
  }
  EXPECT_EQ(goalText({}), "quality");
  EXPECT_EQ(goalFromText("purity:fine: dust:left")->species, "fine: dust");
}

TEST(Goal, OfAnyOtherFormIsRefused)
{
  for (const char* text :
       {"", "Q", "quality:mass", "quality:A:left", "purity", "purity:A", "purity:left", "purity::left",
        "purity:A:up", "purity:A:left:", "purity:A:left:weight", "throughput:A:left", ":mass", "throughput:"})
    EXPECT_FALSE(goalFromText(text)) << text;
}

TEST(Goal, IsMeasuredByNumberAndByMass)
{
  EXPECT_DOUBLE_EQ(of("purity:A:left", known()).value, 30.0 / 40.0);
  EXPECT_DOUBLE_EQ(of("purity:A:left:mass", known()).value, 0.3 / 0.31);
  EXPECT_DOUBLE_EQ(of("purity:B:right", known()).value, 40.0 / 60.0);
  EXPECT_DOUBLE_EQ(of("recovery:A:left", known()).value, 30.0 / 50.0);
  EXPECT_DOUBLE_EQ(of("recovery:B:right:mass", known()).value, 0.04 / 0.05);
  EXPECT_DOUBLE_EQ(of("flow:A:right", known()).value, 1.0);
  EXPECT_DOUBLE_EQ(of("flow:A:right:mass", known()).value, 0.01);
  EXPECT_DOUBLE_EQ(of("throughput", known()).value, 5.0);
  EXPECT_DOUBLE_EQ(of("throughput:mass", known()).value, 0.55 / 20.0);
  EXPECT_DOUBLE_EQ(of("quality", known()).value, 30.0 / 50.0 + 40.0 / 50.0 - 1.0);
}

/// The shares are those of every summary.
TEST(Goal, OfPurityAndRecoveryIsThatOfTheBins)
{
  const SpeciesShares shares = binShares(known().bins)[0];
  EXPECT_EQ(of("purity:A:right", known()).value, shares.right.number.purity);
  EXPECT_EQ(of("purity:A:right:mass", known()).value, shares.right.mass.purity);
  EXPECT_EQ(of("recovery:A:left:mass", known()).value, shares.left.mass.recovery);
}

TEST(Goal, OfNothingIsUndefined)
{
  const Outflow right_only{{"A", "B"}, {{0, 20, 5, 0.0, 0.2}, {0, 0, 6}}, 20.0};
  EXPECT_FALSE(of("purity:A:left", right_only).defined);
  EXPECT_FALSE(of("recovery:B:left", right_only).defined);
  EXPECT_FALSE(of("recovery:C:left", known()).defined);
  EXPECT_TRUE(of("flow:B:right:mass", right_only).defined);
  EXPECT_GT(of("flow:B:right:mass", right_only).error, 0.0);  // none in 20 s, but perhaps in 40 s
  EXPECT_FALSE(of("throughput", Outflow{}).defined);
}

TEST(Goal, OfAllIsStillInDoubt)
{
  const Outflow pure{{"A", "B"}, {{10, 0, 0, 0.1, 0.0}, {0, 10, 0, 0.0, 0.01}}, 20.0};
  for (const char* text : {"purity:A:left", "recovery:A:left", "recovery:A:left:mass"})
  {
    EXPECT_EQ(of(text, pure).value, 1.0);
    EXPECT_GT(of(text, pure).error, 0.05);
  }
}

/// Against the scatter of many windows in which the disks leave independently.
TEST(Goal, HasTheStandardErrorOfIndependentDisks)
{
  constexpr int WINDOWS = 20000;
  std::mt19937_64 random(1);
  const auto drawn = [&](double mean) { return std::poisson_distribution<std::uint64_t>(mean)(random); };
  for (const char* text : {"purity:A:left", "purity:A:left:mass", "purity:B:left:mass",
                           "recovery:A:left:mass", "flow:B:right:mass", "throughput:mass", "throughput"})
  {
    double sum = 0.0;
    double squares = 0.0;
    double errors = 0.0;
    for (int k = 0; k < WINDOWS; ++k)
    {
      Outflow outflow{{"A", "B"}, {{drawn(300), drawn(200), 0}, {drawn(100), drawn(400), 0}}, 20.0};
      for (std::size_t s = 0; s < 2; ++s)
      {
        outflow.bins[s].left_mass = static_cast<double>(outflow.bins[s].left) * (s == 0 ? 0.01 : 0.001);
        outflow.bins[s].right_mass = static_cast<double>(outflow.bins[s].right) * (s == 0 ? 0.01 : 0.001);
      }
      const Measured found = of(text, outflow);
      sum += found.value / WINDOWS;
      squares += found.value * found.value / WINDOWS;
      errors += found.error / WINDOWS;
    }
    EXPECT_NEAR(errors / std::sqrt(squares - sum * sum), 1.0, 0.05) << text;
  }
}
}  // namespace
}  // namespace ratchet_sieve
