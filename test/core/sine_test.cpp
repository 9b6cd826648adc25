#include "model/motion.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
constexpr long double TWO_PI = 6.283185307179586476925286766559L;

TEST(Sine, AgreesWithTheLibraryInLongDouble)
{
  for (int i = -200000; i <= 200000; ++i)
  {
    const double turns = i * 1.2345e-5;
    const auto value = sineCosineOfTurns(turns);
    // 2 pi as a double has a relative error of 2^-54: with two roundings, at most four units.
    const double tolerance = 2.0 * std::numeric_limits<double>::epsilon();
    ASSERT_NEAR(value.sine, static_cast<double>(std::sin(TWO_PI * turns)), tolerance) << turns;
    ASSERT_NEAR(value.cosine, static_cast<double>(std::cos(TWO_PI * turns)), tolerance) << turns;
  }
}

TEST(Sine, QuarterTurnsAreExact)
{
  EXPECT_EQ(sineCosineOfTurns(0.0).sine, 0.0);
  EXPECT_EQ(sineCosineOfTurns(0.0).cosine, 1.0);
  EXPECT_EQ(sineCosineOfTurns(0.25).sine, 1.0);
  EXPECT_EQ(sineCosineOfTurns(0.5).cosine, -1.0);
  EXPECT_EQ(sineCosineOfTurns(-0.25).sine, -1.0);
  EXPECT_EQ(sineCosineOfTurns(123456789.75).sine, -1.0);
}

TEST(Sine, WholeTurnsChangeNothing)
{
  for (const double turns : {0.125, 0.3125, 0.8125})
    EXPECT_EQ(sineCosineOfTurns(turns).sine, sineCosineOfTurns(turns + 1048576.0).sine);
}

}  // namespace
}  // namespace ratchet_sieve
