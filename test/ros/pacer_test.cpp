#include "ratchet_sieve/ros/pacer.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
using Clock = Pacer::Clock;

Clock::time_point after(Clock::time_point start, double seconds)
{
  return start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
}

/// A pacer whose stride does not bind.
Pacer widePacer(double factor)
{
  Pacer pacer(factor);
  for (int k = 0; k < 20; ++k)
    pacer.advanced(pacer.stride(), 0.0);
  return pacer;
}

TEST(Pacer, letsSimulatedTimeFollowWallTime)
{
  Pacer pacer = widePacer(4.0);
  const auto start = Clock::now();
  pacer.anchor(10.0, start);
  EXPECT_NEAR(pacer.allowed(10.0, after(start, 0.05)), 10.2, 1e-8);
}

TEST(Pacer, waitsUntilTheNextInstantIsDueButNotLong)
{
  Pacer pacer(2.0);
  const auto start = Clock::now();
  pacer.anchor(0.0, start);
  EXPECT_NEAR(pacer.wait(0.01, start), 0.005, 1e-8);
  EXPECT_EQ(pacer.wait(100.0, start), Pacer::LONGEST_WAIT);
  EXPECT_EQ(pacer.wait(0.01, after(start, 1.0)), 0.0);
}

TEST(Pacer, neverWaitsWhenAsFastAsItGoes)
{
  Pacer pacer(0.0);
  EXPECT_EQ(pacer.wait(100.0, Clock::now()), 0.0);
  EXPECT_EQ(pacer.allowed(1.0, Clock::now()), 1.0 + pacer.stride());
}

TEST(Pacer, doesNotMakeUpForALongDelay)
{
  Pacer pacer = widePacer(1.0);
  const auto start = Clock::now();
  pacer.anchor(0.0, start);
  pacer.allowed(0.0, after(start, 60.0));
  EXPECT_NEAR(pacer.allowed(0.0, after(start, 60.01)), 0.01, 1e-8);
}

TEST(Pacer, shortensStridesThatTakeLong)
{
  Pacer pacer(0.0);
  const double cost = 1000.0;  // wall over simulated time
  for (int k = 0; k < 100; ++k)
    pacer.advanced(pacer.stride(), cost * pacer.stride());
  EXPECT_LE(cost * pacer.stride(), Pacer::LONGEST_WAIT);
  EXPECT_GE(cost * pacer.stride(), 0.1 * Pacer::LONGEST_WAIT);
}

TEST(Pacer, keepsItsStrideWhereFramesCutAdvancesShort)
{
  Pacer pacer(0.0);
  const double stride = pacer.stride();
  for (int k = 0; k < 100; ++k)
    pacer.advanced(0.1 * stride, 0.0);
  EXPECT_EQ(pacer.stride(), stride);
}
}  // namespace
}  // namespace ratchet_sieve
