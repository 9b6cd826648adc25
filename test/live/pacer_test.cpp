#include "ratchet_sieve/live/pacer.h"

#include <algorithm>

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

/// A pacer whose stride has no effect.
Pacer widePacer(double factor)
{
  Pacer pacer(factor);
  for (int k = 0; k < 20; ++k)
    pacer.advanced(pacer.stride(), 0.0);
  return pacer;
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

/// Runs a simulation with a pacer, on a simulated clock, for `wall` [s].
struct Paced
{
  explicit Paced(double factor) : pacer(widePacer(factor)) { pacer.anchor(time, now); }

  /// @param cost wall time per simulated time
  void run(double wall, double cost)
  {
    const auto end = after(now, wall);
    while (now < end)
    {
      now = after(now, pacer.wait(time + 0.01, now));
      const double target = std::max(pacer.allowed(time, now), time);
      const double taken = cost * (target - time);
      pacer.advanced(target - time, taken);
      now = after(now, taken + 1e-5);  // the rest of the loop
      time = target;
    }
  }

  double time = 0.0;  ///< simulated [s]
  Clock::time_point now = Clock::now();
  Pacer pacer;
};

TEST(Pacer, keepsToTheFactorThatIsAskedFor)
{
  Paced run(3.0);
  run.run(10.0, 0.1);
  EXPECT_NEAR(run.time, 30.0, 0.1);
  EXPECT_EQ(run.pacer.lost(), 0.0);
}

TEST(Pacer, doesNotRaceAfterASlowTimeAndSaysWhatItGaveUp)
{
  Paced run(1.0);
  run.run(10.0, 2.0);  // half the requested factor
  EXPECT_NEAR(run.time, 5.0, 0.2);
  EXPECT_NEAR(run.pacer.lost(), 5.0, 0.2);
  const double slow = run.time;
  const double lost = run.pacer.lost();
  run.run(10.0, 0.01);
  EXPECT_NEAR(run.time - slow, 10.0, 0.2);  // a short delay is caught up
  EXPECT_NEAR(run.pacer.lost(), lost, 0.2);

  Paced twice(2.0);
  twice.run(10.0, 1.0);  // wall time is lost for any factor
  EXPECT_NEAR(twice.pacer.lost(), 5.0, 0.2);

  Paced fast(0.0);
  fast.run(1.0, 5.0);
  EXPECT_EQ(fast.pacer.lost(), 0.0);
}

TEST(Pacer, comesRoundOftenEnoughHoweverSlowTheSimulation)
{
  Paced run(1.0);
  const auto turn = [&] { run.run(1e-9, 1e4); };
  for (int k = 0; k < 50; ++k)  // it learns
    turn();
  const auto begin = run.now;
  for (int k = 0; k < 100; ++k)
    turn();
  EXPECT_LE(run.now, after(begin, 101 * Pacer::LONGEST_WAIT));
}

TEST(Pacer, goesOnAtAnotherFactorWithoutAJump)
{
  Paced run(1.0);
  run.run(2.0, 0.01);
  double before = run.time;
  run.pacer.setFactor(5.0, run.time, run.now);
  EXPECT_EQ(run.pacer.factor(), 5.0);
  EXPECT_NEAR(run.pacer.allowed(run.time, run.now), before, 1e-9);
  run.run(2.0, 0.01);
  EXPECT_NEAR(run.time - before, 10.0, 0.1);

  run.pacer.setFactor(0.0, run.time, run.now);
  run.run(1.0, 0.01);
  before = run.time;
  run.pacer.setFactor(0.5, run.time, run.now);
  EXPECT_NEAR(run.pacer.allowed(run.time, run.now), before, 1e-9);
  run.run(2.0, 0.01);
  EXPECT_NEAR(run.time - before, 1.0, 0.1);
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

/// A run with a speed watch, on a simulated clock.
class Watched
{
public:
  Watched() { watch.update(false, time, lost, now); }

  /// @param factor simulated over wall time @param loss wall time lost per wall time
  void run(double wall, double factor, double loss = 0.0) { turn(true, wall, factor, loss); }
  void stand(double wall) { turn(false, wall, 0.0, 0.0); }

  std::optional<SpeedWatch::Line> line() { return watch.line(1.0, now); }

  SpeedWatch watch;
  double time = 0.0;
  double lost = 0.0;
  SpeedWatch::Clock::time_point now = SpeedWatch::Clock::now();

private:
  void turn(bool under_way, double wall, double factor, double loss)
  {
    constexpr double STEP = 0.01;
    for (double done = 0.0; done < wall - 0.5 * STEP; done += STEP)
    {
      now += std::chrono::milliseconds(10);
      time += factor * STEP;
      lost += loss * STEP;
      watch.update(under_way, time, lost, now);
    }
  }
};

TEST(SpeedWatch, measuresTheSpeedOfARunUnderWay)
{
  Watched run;
  run.run(0.5, 3.0);
  EXPECT_EQ(run.watch.achieved(), std::nullopt);
  run.run(0.6, 3.0);
  EXPECT_NEAR(run.watch.achieved().value(), 3.0, 1e-9);
  EXPECT_FALSE(run.watch.behind());
  EXPECT_FALSE(run.line());
}

TEST(SpeedWatch, countsNeitherPausesNorStepsNorLeaps)
{
  Watched run;
  run.run(0.5, 2.0);
  run.stand(100.0);
  run.time += 50.0;  // stepped
  run.stand(0.01);
  run.run(0.25, 2.0);
  run.time = 0.0;  // reset
  run.run(0.27, 2.0);
  EXPECT_NEAR(run.watch.achieved().value(), 2.0, 1e-9);
}

TEST(SpeedWatch, beginsAnewWhereAnotherSpeedIsAskedFor)
{
  Watched run;
  run.run(2.5, 0.5, 0.5);
  run.watch.forget();
  EXPECT_FALSE(run.watch.behind());
  EXPECT_EQ(run.watch.achieved(), std::nullopt);
  run.run(1.01, 3.0);
  EXPECT_NEAR(run.watch.achieved().value(), 3.0, 1e-9);
  EXPECT_FALSE(run.watch.behind());
}

TEST(SpeedWatch, isBehindUntilAFullPeriodWithoutALoss)
{
  Watched run;
  run.run(2.0, 0.5, 0.5);
  EXPECT_TRUE(run.watch.behind());
  EXPECT_NEAR(run.watch.achieved().value(), 0.5, 1e-9);
  run.run(1.0, 1.0);
  run.run(0.5, 1.0);
  EXPECT_FALSE(run.watch.behind());
  run.lost += 0.2;  // a single delay counts as well
  run.run(0.6, 1.0);
  EXPECT_TRUE(run.watch.behind());
}

/// A loss is reported with the speed of the same period, not with that of the one before.
TEST(SpeedWatch, tellsALossWithTheSpeedThatItCameFrom)
{
  Watched run;
  run.run(1.5, 1.0);
  run.run(0.2, 0.0, 1.0);
  EXPECT_FALSE(run.line());
  run.run(0.4, 1.0);
  ASSERT_TRUE(run.watch.behind());
  EXPECT_NEAR(run.watch.achieved().value(), 0.8, 0.011);
  EXPECT_TRUE(run.line());
}

TEST(SpeedWatch, saysThatARunKeepsUpAgainOnlyAfterAWhile)
{
  Watched run;
  run.run(2.0, 0.5, 0.5);
  EXPECT_TRUE(run.line());
  run.run(2.0, 1.0);
  EXPECT_FALSE(run.line());
  run.run(2.0, 0.5, 0.5);
  EXPECT_FALSE(run.line());
  run.run(10.0, 1.0);
  EXPECT_TRUE(run.line());
  EXPECT_FALSE(run.line());
}

TEST(SpeedWatch, showsAsManyFiguresAsTellASpeedFromWhatWasAskedFor)
{
  EXPECT_EQ(tooSlowText(0.5, 1.0), "too slow: 0.5 times real time instead of 1");
  EXPECT_EQ(tooSlowText(19.93, 20.0), "too slow: 19.9 times real time instead of 20");
  EXPECT_EQ(tooSlowText(19.98, 20.0), "too slow: 19.98 times real time instead of 20");
  EXPECT_EQ(tooSlowText(19.9996, 20.0), "too slow: 19.9996 times real time instead of 20");
  EXPECT_EQ(tooSlowText(19.999999, 20.0), "too slow: a little less than 20 times real time");
  EXPECT_EQ(tooSlowText(1.9e5, 1e6), "too slow: 1.9e+05 times real time instead of 1e+06");
}

TEST(SpeedWatch, saysSoNowAndThenAndOnceThatItIsOver)
{
  Watched run;
  int warnings = 0;
  for (int k = 0; k < 30; ++k)
  {
    run.run(1.0, 0.5, 0.5);
    const auto line = run.line();
    if (!line)
      continue;
    ++warnings;
    EXPECT_TRUE(line->warning);
    EXPECT_EQ(line->text.rfind("too slow: 0.5 times real time instead of 1; ", 0), 0u) << line->text;
  }
  EXPECT_EQ(warnings, 3);
  run.run(2.5, 1.0);
  const auto line = run.line();
  ASSERT_TRUE(line);
  EXPECT_FALSE(line->warning);
  EXPECT_EQ(line->text, "keeps up again: 1 times real time");
  run.run(2.5, 1.0);
  EXPECT_FALSE(run.line());
}
}  // namespace
}  // namespace ratchet_sieve
