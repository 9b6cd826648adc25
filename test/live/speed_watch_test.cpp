#include "ratchet_sieve/live/pacer.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
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
