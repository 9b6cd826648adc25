// The lines that a sweep prints: its progress and its warnings.
#include "ratchet_sieve/sweep/sweep_report.h"

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
  EXPECT_EQ(sweepProgressText(progress),
            "118 of 240 done, 2 running, 2 failed, 6 with warnings  2 cases/s  1:00 to go");
}

using Lines = std::vector<std::string>;

TEST(WarningTally, SaysNothingOfCasesWithoutWarnings)
{
  const WarningTally tally;
  EXPECT_EQ(tally.warned(), 0u);
  EXPECT_EQ(tally.lines(1, "case"), Lines());
}

TEST(WarningTally, CountsTheCasesOfEachWarningTheMostFrequentFirst)
{
  WarningTally tally;
  tally.add(0, "a rare one");
  tally.add(1, "no disk at all", 4);
  EXPECT_EQ(tally.warned(), 5u);
  EXPECT_EQ(tally.lines(5, "case"),
            (Lines{"in 4 of 5 cases: no disk at all", "in 1 of 5 cases: a rare one"}));
  tally.add(5, "no disk at all");
  tally.add(5, "no disk at all");
  EXPECT_EQ(tally.warned(), 6u);
  EXPECT_EQ(tally.lines(5, "case").front(), "in every case: no disk at all");
}

TEST(WarningTally, TakesWarningsOfOneRuleAsOne)
{
  WarningTally tally;
  tally.add(0, "species.0.radius = 1.5 m: large [large-disk]");
  tally.add(0, "species.1.radius = 2 m: large [large-disk]");
  tally.add(1, "species.1.radius = 2 m: large [large-disk]");
  tally.add(1, "species.1.radius = 2 m: large [dense-disk]");
  EXPECT_EQ(tally.warned(), 2u);
  EXPECT_EQ(tally.lines(3, "case"),
            (Lines{"in 2 of 3 cases, such as: species.0.radius = 1.5 m: large [large-disk]",
                   "in 1 of 3 cases: species.1.radius = 2 m: large [dense-disk]"}));
}

TEST(WarningTally, ShowsFiveAndCountsTheRest)
{
  WarningTally tally;
  for (const char* warning : {"a", "b", "c", "d", "e", "f"})
    tally.add(0, warning);
  EXPECT_EQ(tally.lines(2, "case").size(), 6u);
  EXPECT_EQ(tally.lines(2, "case").back(), "and 1 other warning");
}

}  // namespace
}  // namespace ratchet_sieve
