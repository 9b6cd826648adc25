#include "model/base_motion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "constants.h"

namespace ratchet_sieve
{
namespace
{
constexpr double UNLIMITED = 10.0;

TEST(BaseMotion, StandsWhereItsPhaseIsAndGoesOnFromThere)
{
  BaseDefinition base;
  base.frequency = 0.0;
  base.phase = 0.7;
  BaseMotion motion(base, UNLIMITED);
  const auto expectTheSineAt = [&motion](double time)
  {
    while (motion.nextChange() && *motion.nextChange() <= time)
      motion.beginSegment(*motion.nextChange());
    const DriveState state = motion.state(time);
    EXPECT_NEAR(state.displacement, state.amplitude * std::sin(state.phase), 1e-15) << time;
    return state;
  };
  EXPECT_EQ(expectTheSineAt(0.1).velocity, 0.0);
  motion.command(Quantity::AMPLITUDE, 0.001, 0.1);
  expectTheSineAt(0.11);
  EXPECT_EQ(expectTheSineAt(9.0).velocity, 0.0);
  EXPECT_EQ(motion.state(9.0).amplitude, 0.001);
  motion.command(Quantity::FREQUENCY, 20.0, 9.0);
  EXPECT_NEAR(expectTheSineAt(9.0).phase, 0.7, 1e-15);
  for (const double time : {9.3, 20.0})
    EXPECT_GT(std::abs(expectTheSineAt(time).velocity), 0.0);
}

TEST(BaseMotion, ComesToItsSetpointsExactlyAndStops)
{
  BaseMotion motion(BaseDefinition(), UNLIMITED);
  motion.command(Quantity::INCLINATION, 0.0523, 0.25);
  motion.command(Quantity::FREQUENCY, 11.1, 0.25);
  int segments = 0;
  double before = motion.at(0.25).displacement.y();
  double time = 0.25;
  while (const auto change = motion.nextChange())
  {
    before = motion.at(*change).displacement.y();
    time = *change;
    motion.beginSegment(time);
    EXPECT_NEAR(motion.at(time).displacement.y(), before, 1e-15) << "the phase is continuous";
    ASSERT_LT(++segments, 10);
  }
  EXPECT_EQ(motion.state(time).inclination, 0.0523);
  EXPECT_EQ(motion.state(time).frequency, 11.1);
  EXPECT_NEAR(time, 0.25 + (23.0 - 11.1) / 10.0, 1e-12);
}

TEST(BaseMotion, ASetpointAHairAwayIsReachedAtOnce)
{
  BaseMotion motion(BaseDefinition(), UNLIMITED);
  motion.command(Quantity::FREQUENCY, 23.000000000000004, 31.5);
  EXPECT_FALSE(motion.nextChange());
  EXPECT_EQ(motion.state(31.5).frequency, 23.000000000000004);
}

TEST(BaseMotion, RandomCommandsAreFollowedWithoutEnd)
{
  BaseMotion motion(BaseDefinition(), UNLIMITED);
  double time = 0.0;
  for (int k = 0; k < 2000; ++k)
  {
    motion.command(Quantity::INCLINATION, 0.01 * (k * 7919 % 13), time);
    motion.command(Quantity::FREQUENCY, 0.1 * (k * 104729 % 300), time);
    time += 0.0173 * (k % 5);
    int segments = 0;
    while (motion.nextChange() && *motion.nextChange() <= time)
    {
      motion.beginSegment(*motion.nextChange());
      ASSERT_LT(++segments, 10);
    }
  }
}

TEST(BaseMotion, ANewCommandTurnsARunningSlewAround)
{
  BaseMotion motion(BaseDefinition(), UNLIMITED);
  motion.command(Quantity::INCLINATION, 0.2, 0.0);
  motion.command(Quantity::INCLINATION, -0.2, 1.0);
  EXPECT_NEAR(motion.state(1.0).inclination, 0.1, 1e-15);
  EXPECT_NEAR(motion.state(2.0).inclination, 0.0, 1e-15);
  EXPECT_EQ(motion.state(2.0).commanded_inclination, -0.2);
}

TEST(BaseMotion, SegmentsOfATurnAreNoLongerThanAllowed)
{
  BaseMotion motion(BaseDefinition(), 0.001);
  motion.command(Quantity::INCLINATION, 0.01, 0.0);
  int segments = 0;
  while (const auto change = motion.nextChange())
  {
    motion.beginSegment(*change);
    ++segments;
  }
  EXPECT_NEAR(segments, 10, 1);
  EXPECT_EQ(motion.state(1.0).inclination, 0.01);
}

TEST(BaseMotion, ThePhaseIsAsGoodAfterAMillionSecondsAsAtTheStart)
{
  BaseDefinition base;
  base.frequency = 22.7;
  BaseMotion motion(base, UNLIMITED);
  for (int epoch = 0; epoch < 250000; ++epoch)
    motion.rebase(4.0);
  // 22.7 as a double times 10^6 s; its fraction in long double.
  const long double turns = static_cast<long double>(22.7) * 1.0e6L;
  const double phase = 2.0 * PI * static_cast<double>(turns - std::floor(turns));
  // 250,000 roundings of at most 2^-54 turns each: 2 pi 250,000 / 2^54 = 9e-11 if all have the same sign.
  EXPECT_NEAR(std::remainder(motion.state(0.0).phase - phase, 2.0 * PI), 0.0, 9e-11);
}

}  // namespace
}  // namespace ratchet_sieve
