#include "ratchet_sieve/live/pour_log.h"

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
PourLog::Clock::time_point wallTime(double seconds)
{
  return PourLog::Clock::time_point(
      std::chrono::duration_cast<PourLog::Clock::duration>(std::chrono::duration<double>(seconds)));
}

TEST(PourLog, BeginsWhenThePourHasLastedForAPeriod)
{
  PourLog log;
  EXPECT_EQ(log.line(0, 9000, wallTime(100.0)), std::nullopt);
  EXPECT_EQ(log.line(1000, 9000, wallTime(101.9)), std::nullopt);
  EXPECT_EQ(log.line(2000, 9000, wallTime(102.1)), "2000 of 9000 disks poured");
  EXPECT_EQ(log.line(3000, 9000, wallTime(104.0)), std::nullopt);
  EXPECT_EQ(log.line(4000, 9000, wallTime(104.2)), "4000 of 9000 disks poured");
}

/// The pour of a reset, long after the one at the start.
TEST(PourLog, BeginsAnewWithAnotherPour)
{
  PourLog log;
  EXPECT_EQ(log.line(0, 1500, wallTime(0.0)), std::nullopt);
  for (const double start : {60.0, 120.0})
  {
    EXPECT_EQ(log.line(0, 1500, wallTime(start)), std::nullopt);
    EXPECT_EQ(log.line(1000, 1500, wallTime(start + 1.0)), std::nullopt);
  }
  EXPECT_EQ(log.line(0, 9000, wallTime(180.0)), std::nullopt);
  EXPECT_EQ(log.line(1000, 9000, wallTime(182.5)), "1000 of 9000 disks poured");
}
}  // namespace
}  // namespace ratchet_sieve
