#include "ratchet_sieve/sweep/warning_tally.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{

using Lines = std::vector<std::string>;

TEST(WarningTally, SaysNothingOfCasesWithoutWarnings)
{
  WarningTally tally;
  tally.add({});
  EXPECT_EQ(tally.warned(), 0u);
  EXPECT_EQ(tally.lines(1, "case"), Lines());
}

TEST(WarningTally, CountsTheCasesOfEachWarningTheMostFrequentFirst)
{
  WarningTally tally;
  tally.add({"a rare one"});
  tally.add({"no disk at all"}, 4);
  EXPECT_EQ(tally.warned(), 5u);
  EXPECT_EQ(tally.lines(5, "case"),
            (Lines{"in 4 of 5 cases: no disk at all", "in 1 of 5 cases: a rare one"}));
  tally.add({"no disk at all", "no disk at all"});
  EXPECT_EQ(tally.lines(5, "case").front(), "in every case: no disk at all");
}

TEST(WarningTally, TakesWarningsOfOneRuleAsOne)
{
  WarningTally tally;
  tally.add({"species.0.radius = 1.5 m: large [large-disk]", "species.1.radius = 2 m: large [large-disk]"});
  tally.add({"species.1.radius = 2 m: large [large-disk]", "species.1.radius = 2 m: large [dense-disk]"});
  EXPECT_EQ(tally.lines(3, "case"),
            (Lines{"in 2 of 3 cases, such as: species.0.radius = 1.5 m: large [large-disk]",
                   "in 1 of 3 cases: species.1.radius = 2 m: large [dense-disk]"}));
}

TEST(WarningTally, ShowsFiveAndCountsTheRest)
{
  WarningTally tally;
  tally.add({"a", "b", "c", "d", "e", "f"});
  EXPECT_EQ(tally.lines(2, "case").size(), 6u);
  EXPECT_EQ(tally.lines(2, "case").back(), "and 1 other warning");
}

}  // namespace
}  // namespace ratchet_sieve
