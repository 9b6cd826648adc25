#include "ratchet_sieve/sweep/sweep_progress.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{

TEST(SweepProgress, SaysWhatIsKnown)
{
  SweepProgress progress;
  progress.cases = 240;
  progress.running = 2;
  EXPECT_EQ(sweepProgressText(progress), "0 of 240 done, 2 running");
  progress.done = 118;
  progress.failed = 2;
  progress.finished_here = 20;
  progress.wall = 10.0;
  progress.warned = 6;
  progress.best = SettingMean{};
  progress.best->separation = -0.75;
  EXPECT_EQ(
      sweepProgressText(progress),
      "118 of 240 done, 2 running, 2 failed, 6 with warnings  2 cases/s  1:00 to go  best mean Q 0.750");
  progress.best->error = 0.03;
  EXPECT_NE(sweepProgressText(progress).find("  best mean Q 0.750 +- 0.030"), std::string::npos);
}

TEST(SweepProgress, NamesADurationAsPeopleDo)
{
  EXPECT_EQ(durationText(7.2), "0:07");
  EXPECT_EQ(durationText(3723.0), "1:02:03");
  EXPECT_EQ(durationText(10 * 86400.0), "10 days");
  EXPECT_EQ(durationText(3.2 * 365.25 * 86400.0), "3.2 years");
}

}  // namespace
}  // namespace ratchet_sieve
