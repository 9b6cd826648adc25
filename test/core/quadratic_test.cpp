#include "search/contact_search.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "draws.h"

namespace ratchet_sieve
{
namespace
{

TEST(FirstClosingTime, KnownAnswers)
{
  EXPECT_DOUBLE_EQ(*firstClosingTime(2.0, -1.0, 0.0), 2.0);
  EXPECT_FALSE(firstClosingTime(2.0, 1.0, 0.0));
  EXPECT_FALSE(firstClosingTime(1.0, -1.0, 2.0));               // turns around at 3/4
  EXPECT_DOUBLE_EQ(*firstClosingTime(0.5, 0.0, -1.0), 1.0);     // falls
  EXPECT_DOUBLE_EQ(*firstClosingTime(0.0, 3.0, -2.0), 3.0);     // thrown up from contact
  EXPECT_EQ(*firstClosingTime(-1e-18, -1.0, 0.0), 0.0);         // overlapping and approaching: now
  EXPECT_DOUBLE_EQ(*firstClosingTime(-1e-18, 3.0, -2.0), 3.0);  // overlapping and separating: ignored
  EXPECT_FALSE(firstClosingTime(-1e-18, 3.0, 0.0));
}

TEST(FirstClosingTime, IsTheFirstRootOfRandomParabolas)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const double gap = drawn(1e-3, 1.0);
        const double rate = drawn(-5.0, 5.0);
        const double accel = drawn(-10.0, 10.0);
        const auto at = [=](double t) { return gap + rate * t + 0.5 * accel * t * t; };
        const auto root = firstClosingTime(gap, rate, accel);
        const double end = root.value_or(3.0);
        for (int i = 0; i < 1000; ++i)
          RC_ASSERT(at(end * i / 1000.0) > -1e-12);
        if (root)
          RC_ASSERT(std::abs(at(*root)) < 1e-10 * (1.0 + *root * *root));
      }));
}

TEST(GuaranteedFreeTime, NoGapWithinTheBoundCloses)
{
  EXPECT_TRUE(rc::check(
      []
      {
        // A gap whose second derivative is anywhere within the bound: a parabola plus a sine.
        const double bound = drawn(0.1, 50.0);
        const double omega = drawn(1.0, 200.0);
        const double wave = drawn(0.0, 0.5) * bound / (omega * omega);
        const double accel = drawn(-0.5, 2.0) * bound;
        const double phase = drawn(0.0, 6.28);
        const double gap = drawn(0.0, 0.02);
        const double rate = drawn(-2.0, 2.0);
        const double free = guaranteedFreeTime(gap, rate, bound);
        const auto at = [=](double t)
        {
          return gap + rate * t + 0.5 * accel * t * t +
                 wave * (std::sin(omega * t + phase) - std::sin(phase) - omega * t * std::cos(phase));
        };
        for (int i = 0; i <= 1000; ++i)
          RC_ASSERT(at(free * i / 1000.0) > -1e-14);
      }));
}

TEST(GuaranteedFreeTime, UsedUpAndClosingIsNow)
{
  EXPECT_EQ(guaranteedFreeTime(-1e-18, -1.0, 10.0), 0.0);
  EXPECT_EQ(guaranteedFreeTime(0.0, -1.0, 10.0), 0.0);
  EXPECT_DOUBLE_EQ(guaranteedFreeTime(0.0, 1.0, 10.0), 0.2);
  EXPECT_DOUBLE_EQ(guaranteedFreeTime(3.0, -2.0, 0.0), 1.5);
  for (const double gap : {-1e-18, 0.0, 1.0})
    for (const double rate : {0.0, 1.0})
      EXPECT_EQ(guaranteedFreeTime(gap, rate, 0.0), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace ratchet_sieve
