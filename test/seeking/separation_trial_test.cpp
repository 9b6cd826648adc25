#include "ratchet_sieve/seeking/separation_trial.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
constexpr double ANGLE = 0.2;

TrialOptions options()
{
  return {2.0, 3.0, 20.0, 10};
}

BaseFrame baseAt(double time, double applied = ANGLE, double commanded = ANGLE)
{
  BaseFrame frame;
  frame.time = time;
  frame.base.inclination = applied;
  frame.base.commanded_inclination = commanded;
  frame.base.frequency = frame.base.commanded_frequency = 23.0;
  frame.base.amplitude = frame.base.commanded_amplitude = 0.002;
  return frame;
}

/// Every second ten of A, of 1/8 kg each, fall on the right, and five of B on the left.
BinFrame binsAt(double time)
{
  BinFrame frame;
  frame.time = time;
  frame.species = {"A", "B"};
  const auto right = static_cast<std::uint64_t>(10.0 * time);
  frame.bins = {{0, right, 3, 0.0, 0.125 * static_cast<double>(right)},
                {static_cast<std::uint64_t>(5.0 * time), 0, 4}};
  return frame;
}

/// Frames of both kinds, twice a second.
void run(SeparationTrial& trial, double from, double to)
{
  for (double time = from; time <= to; time += 0.5)
  {
    trial.take(baseAt(time));
    trial.take(binsAt(time));
  }
}

TEST(SeparationTrial, countsWhatLeavesAfterTheDwell)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  run(trial, 5.0, 9.5);
  EXPECT_FALSE(trial.result());
  run(trial, 10.0, 10.0);
  ASSERT_TRUE(trial.result());
  const Separation& result = *trial.result();
  EXPECT_EQ(result.inclination, ANGLE);
  EXPECT_EQ(result.begin, 7.0);
  EXPECT_EQ(result.end, 10.0);
  EXPECT_EQ(result.bins[0].right, 30u);
  EXPECT_EQ(result.bins[0].left, 0u);
  EXPECT_EQ(result.bins[0].right_mass, 3.75);
  EXPECT_EQ(result.duration, 3.0);
  EXPECT_EQ(result.bins[1].left, 15u);
  EXPECT_EQ(result.bins[1].on_base, 4u);
}

TEST(SeparationTrial, waitsUntilTheBaseStands)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  trial.take(baseAt(0.0, 0.0, 0.0));
  EXPECT_FALSE(trial.followed());
  trial.take(baseAt(0.5, 0.1));
  EXPECT_TRUE(trial.followed());
  trial.take(binsAt(0.5));
  trial.take(binsAt(20.0));
  trial.take(baseAt(20.0, 0.19));
  EXPECT_FALSE(trial.result());
  run(trial, 21.0, 26.0);
  ASSERT_TRUE(trial.result());
  EXPECT_EQ(trial.result()->begin, 23.0);
}

TEST(SeparationTrial, beginsAnewWhereTheBaseIsMoved)
{
  BaseFrame slewing = baseAt(8.5);
  slewing.base.frequency = 22.0;
  for (const BaseFrame& moved : {baseAt(8.5, 0.1), baseAt(8.5, ANGLE, 0.3), slewing})
  {
    SeparationTrial trial(options());
    trial.begin(ANGLE);
    run(trial, 5.0, 8.0);
    trial.take(moved);
    run(trial, 9.0, 13.5);
    EXPECT_FALSE(trial.result());
    run(trial, 14.0, 14.0);
    ASSERT_TRUE(trial.result());
    EXPECT_EQ(trial.result()->begin, 11.0);
  }
}

TEST(SeparationTrial, goesOnWithoutADwellAtTheSameInclination)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  run(trial, 5.0, 10.0);
  ASSERT_TRUE(trial.result());
  trial.begin(ANGLE);
  EXPECT_FALSE(trial.result());
  EXPECT_TRUE(trial.followed());
  run(trial, 10.5, 13.0);
  ASSERT_TRUE(trial.result());
  EXPECT_EQ(trial.result()->begin, 10.0);
  EXPECT_EQ(trial.result()->bins[0].right, 30u);
}

TEST(SeparationTrial, prolongsAWindowWithTooFewDisks)
{
  TrialOptions many = options();
  many.least_disks = 50;
  SeparationTrial trial(many);
  trial.begin(ANGLE);
  run(trial, 5.0, 16.5);
  EXPECT_FALSE(trial.result());
  run(trial, 17.0, 17.0);
  ASSERT_TRUE(trial.result());
  EXPECT_EQ(trial.result()->bins[1].left, 50u);
}

TEST(SeparationTrial, endsTheLongestWindowThoughASpeciesIsKeptBack)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  const auto without_b = [&](double time)
  {
    BinFrame frame = binsAt(time);
    frame.bins[1] = {7, 7, 100};
    trial.take(baseAt(time));
    trial.take(frame);
  };
  for (double time = 0.0; time <= 21.5; time += 0.5)
    without_b(time);
  EXPECT_FALSE(trial.result());
  without_b(22.0);
  ASSERT_TRUE(trial.result());
  EXPECT_EQ(trial.result()->bins[1].counted(), 0u);
}

TEST(SeparationTrial, takesNothingFromASieveThatNothingLeaves)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  for (double time = 0.0; time <= 200.0; time += 0.5)
  {
    BinFrame frame = binsAt(3.0);
    frame.time = time;
    trial.take(baseAt(time));
    trial.take(frame);
  }
  EXPECT_FALSE(trial.result());
}

TEST(SeparationTrial, beginsAnewWhereTimeGoesBack)
{
  for (const bool base_first : {true, false})
  {
    SeparationTrial trial(options());
    trial.begin(ANGLE);
    run(trial, 5.0, 9.0);
    // After a reset the two topics may arrive in any order, with old frames in between.
    if (base_first)
    {
      trial.take(baseAt(0.0));
      trial.take(binsAt(9.5));
      trial.take(binsAt(0.0));
    }
    else
    {
      trial.take(binsAt(0.0));
      trial.take(baseAt(9.5));
      trial.take(baseAt(0.0));
    }
    run(trial, 0.5, 4.5);
    EXPECT_FALSE(trial.result());
    run(trial, 5.0, 5.5);
    ASSERT_TRUE(trial.result());
    EXPECT_GE(trial.result()->begin, 2.0);
    EXPECT_LE(trial.result()->end, 5.5);
    EXPECT_EQ(trial.result()->bins[0].right, 30u);
  }
}

TEST(SeparationTrial, beginsAnewWhereCountsGoBack)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  run(trial, 5.0, 9.0);
  for (double time = 9.5; time <= 14.5; time += 0.5)
  {
    BinFrame poured_anew = binsAt(time - 9.5);
    poured_anew.time = time;
    trial.take(poured_anew);
    trial.take(baseAt(time));
    EXPECT_EQ(trial.result().has_value(), time == 14.5) << time;
  }
  EXPECT_EQ(trial.result()->bins[0].right, 30u);
}

TEST(SeparationTrial, isInterrupted)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  run(trial, 5.0, 9.5);
  trial.interrupt();
  EXPECT_FALSE(trial.followed());
  run(trial, 10.0, 14.5);
  EXPECT_FALSE(trial.result());
  run(trial, 15.0, 15.0);
  ASSERT_TRUE(trial.result());
  EXPECT_EQ(trial.result()->begin, 12.0);
}

/// The topics have separate connections: either may be ahead by any time.
TEST(SeparationTrial, goesByTheTimesInTheFrames)
{
  for (const double ahead : {-5.0, -0.5, 0.5, 5.0})
  {
    SeparationTrial trial(options());
    trial.begin(ANGLE);
    for (double time = 0.0; time <= 30.0 && !trial.result(); time += 0.5)
    {
      trial.take(baseAt(time, time < 4.0 ? 0.0 : ANGLE));
      if (time + ahead >= 0.0)
        trial.take(binsAt(time + ahead));
    }
    ASSERT_TRUE(trial.result()) << ahead;
    EXPECT_GE(trial.result()->begin, 6.0) << ahead;
    EXPECT_EQ(trial.result()->bins[0].right,
              static_cast<std::uint64_t>(10.0 * (trial.result()->end - trial.result()->begin)));
  }
}

/// Bins from a time at which the base was moved, according to a later frame, do not count.
TEST(SeparationTrial, judgesBinsByTheBaseOfTheirTime)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  for (double time = 0.0; time <= 30.0 && !trial.result(); time += 0.5)
  {
    trial.take(baseAt(time, ANGLE, time == 4.5 ? 0.3 : ANGLE));
    trial.take(binsAt(time + 4.0));
  }
  ASSERT_TRUE(trial.result());
  EXPECT_GE(trial.result()->begin, 7.0);
}

/// A frame from before a reset must not delay the trial, although no count shows the reset.
TEST(SeparationTrial, waitsForNoTimeThatWasTakenBack)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  BinFrame empty = binsAt(0.0);
  empty.time = 100.0;  // before any disk has fallen
  trial.take(baseAt(0.0));
  trial.take(empty);
  for (double time = 0.5; time <= 6.0; time += 0.5)
  {
    trial.take(binsAt(time));
    trial.take(baseAt(time));
  }
  EXPECT_TRUE(trial.result());
}

TEST(SeparationTrial, tellsTheMeanTemperatureAndPaceOfTheWindow)
{
  SeparationTrial trial(options());
  trial.begin(ANGLE);
  StatisticsFrame statistics;
  const auto hear = [&](double time, double temperature, double pace)
  {
    statistics.time = time;
    statistics.species = {{"A", {}, temperature}, {"B", {}, 2.0 * temperature}};
    statistics.real_time_factor = pace;
    trial.take(statistics);
  };
  // An interrupted window does not count.
  run(trial, 0.0, 3.0);
  hear(3.0, 50.0, 50.0);
  trial.take(baseAt(3.5, 0.1));
  run(trial, 5.0, 6.5);
  hear(6.5, 100.0, 100.0);
  run(trial, 7.0, 8.0);
  hear(8.0, 1.0, 10.0);
  run(trial, 8.5, 9.0);
  hear(9.0, 2.0, 40.0);
  run(trial, 9.5, 10.0);
  ASSERT_TRUE(trial.result());
  EXPECT_EQ(trial.result()->granular_temperature, (std::vector<double>{1.5, 3.0}));
  EXPECT_EQ(trial.result()->real_time_factor, 16.0);  // 2 s in 1/10 + 1/40 s
}
}  // namespace
}  // namespace ratchet_sieve
