#include "ratchet_sieve/live/drives.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
constexpr double NEVER = std::numeric_limits<double>::infinity();
constexpr Quantity F = Quantity::FREQUENCY;

/// At rest at 20 Hz and 2 mm.
Drives drivesOf(const DriveSettings& frequency, const DriveSettings& amplitude = {})
{
  BaseDefinition base;
  base.frequency = 20.0;
  base.amplitude = 0.002;
  return {{{{}, frequency, amplitude}}, base, 0.0};
}

double outputAt(Drives& drives, double time)
{
  while (drives.nextTime() <= time)
    drives.advanceTo(drives.nextTime());
  return drives.output(F);
}

TEST(Drives, PassASetpointOnUnchangedByDefault)
{
  Drives drives = drivesOf({});
  EXPECT_EQ(drives.output(F), 20.0);
  EXPECT_EQ(drives.nextTime(), NEVER);
  drives.ask(F, 23.0, 7.0);
  EXPECT_EQ(drives.nextTime(), 7.0);
  EXPECT_EQ(outputAt(drives, 7.0), 23.0);
  EXPECT_EQ(drives.nextTime(), NEVER);
}

TEST(Drives, HaveADeadTimeInWhichTheyKeepAllSetpoints)
{
  Drives drives = drivesOf({2.0});
  drives.ask(F, 21.0, 1.0);
  drives.ask(F, 22.0, 1.5);
  EXPECT_EQ(drives.asked(F), 22.0);
  EXPECT_EQ(outputAt(drives, 2.9), 20.0);
  EXPECT_EQ(outputAt(drives, 3.4), 21.0);
  EXPECT_EQ(outputAt(drives, 3.5), 22.0);
}

TEST(Drives, LagExponentiallyAndArrive)
{
  Drives drives = drivesOf({0.0, 0.5});
  drives.ask(F, 30.0, 0.0);
  EXPECT_NEAR(outputAt(drives, 0.5), 30.0 - 10.0 * std::exp(-1.0), 10.0 * 0.05);  // within a step
  // Another goal on the way: from where it is then, not from its last step.
  drives.ask(F, 0.0, 0.512);
  drives.advanceTo(0.512);
  EXPECT_NEAR(drives.output(F), 30.0 - 10.0 * std::exp(-0.512 / 0.5), 1e-12);
  EXPECT_EQ(outputAt(drives, 10.0), 0.0);
  EXPECT_EQ(drives.nextTime(), NEVER);
}

TEST(Drives, HaveAResolutionAnOffsetAndLimits)
{
  EXPECT_DOUBLE_EQ(drivesOf({0.0, 0.0, 3.0}).output(F), 21.0);
  EXPECT_DOUBLE_EQ(drivesOf({0.0, 0.0, 3.0, {}, 0.5}).output(F), 21.5);
  EXPECT_EQ(drivesOf({0.0, 0.0, 0.0, {}, -50.0}).output(F), 0.0);
}

TEST(Drives, GiveLessAmplitudeAtAnotherFrequency)
{
  Drives drives = drivesOf({}, {0.0, 0.0, 0.0, {{20.0, 1.0}, {40.0, 0.5}}});
  for (const auto& [frequency, factor] :
       {std::pair(10.0, 1.0), {20.0, 1.0}, {30.0, 0.75}, {40.0, 0.5}, {60.0, 0.5}})
  {
    drives.ask(F, frequency, 1.0);
    drives.advanceTo(1.0);
    EXPECT_DOUBLE_EQ(drives.output(Quantity::AMPLITUDE), factor * 0.002);
  }
}

TEST(Drives, StayWhereTheyAreHeld)
{
  Drives drives = drivesOf({});
  drives.setFault(F, "stuck", 19.0);
  drives.ask(F, 23.0, 1.0);
  EXPECT_EQ(outputAt(drives, 1.0), 19.0);
  drives.setFault(F, "off", 19.0);
  EXPECT_EQ(drives.output(F), 0.0);
  drives.setFault(F, "none", 19.0);
  EXPECT_EQ(drives.output(F), 23.0);
}

}  // namespace
}  // namespace ratchet_sieve
