#include "ratchet_sieve/ros/seek_node.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
SeekReport firstStep()
{
  SeekReport report;
  report.trial = 1;
  report.separation.end = 8.5;
  report.separation.species = {"A", "B"};
  report.separation.bins = {{0, 100, 5}, {0, 100, 6}};
  report.score = scoreOf(report.separation);
  report.best = report.next = 0.1;
  return report;
}

TEST(SeekReport, tellsNoQualityThatWasNotMeasured)
{
  SeekReport report = firstStep();
  EXPECT_EQ(trialText(report),
            "trial 1, approach: 0.0000 rad, 0.0 to 8.5 s: Q 0.00 +- 0.01 (A 0 left 100 right, B 0 left 100 "
            "right); best 0.1000 rad, Q not measured yet; next approach 0.1000 rad");
  EXPECT_TRUE(toMessage(report).quality_defined);
  EXPECT_FALSE(toMessage(report).best_quality_defined);

  report.separation.bins[1] = {0, 0, 106};  // kept back
  report.separation.real_time_factor = 0.3;
  report.score = scoreOf(report.separation);
  report.best_score = firstStep().score;
  EXPECT_EQ(trialText(report),
            "trial 1, approach: 0.0000 rad, 0.0 to 8.5 s: Q undefined (A 0 left 100 right, B 0 left 0 right; "
            "0.3 times real time); best 0.1000 rad, Q 0.00 +- 0.01; next approach 0.1000 rad");
  EXPECT_FALSE(toMessage(report).quality_defined);
  EXPECT_TRUE(toMessage(report).best_quality_defined);
}

TEST(SeekReport, tellsTheValueOfItsGoal)
{
  SeekReport report = firstStep();
  report.goal = *goalFromText("purity:B:right");
  report.separation.duration = 8.5;
  report.score = report.best_score = scoreOf(report.separation, report.goal);
  EXPECT_EQ(trialText(report),
            "trial 1, approach: 0.0000 rad, 0.0 to 8.5 s: purity:B:right 0.50 +- 0.04 (A 0 left 100 right, B "
            "0 left "
            "100 right); best 0.1000 rad, purity:B:right 0.50 +- 0.04; next approach 0.1000 rad");
  const SeekTrial message = toMessage(report);
  EXPECT_EQ(message.goal, "purity:B:right");
  EXPECT_EQ(message.value, 0.5);
  EXPECT_TRUE(message.value_defined);
  EXPECT_EQ(message.best_value_error, report.score.goal.error);
  EXPECT_EQ(message.quality, 0.0);

  report.goal = *goalFromText("flow:A:right");
  report.score = report.best_score = scoreOf(report.separation, report.goal);
  EXPECT_NE(trialText(report).find("flow:A:right 11.8 +- 1.2 ("), std::string::npos) << trialText(report);
}
}  // namespace
}  // namespace ratchet_sieve
