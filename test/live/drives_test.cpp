#include "ratchet_sieve/live/drives.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace ratchet_sieve
{
namespace
{
constexpr double NEVER = std::numeric_limits<double>::infinity();
constexpr Interval ANY{-10.0, 10.0};

/// Lets a drive come to a time.
void come(Actuator& drive, double time)
{
  while (drive.nextTime() <= time)
    drive.advanceTo(drive.nextTime());
}

double outputOf(const DriveSettings& settings, double setpoint)
{
  return Actuator(settings, setpoint, 0.0).output(0.0, ANY);
}

TEST(Actuator, PassesASetpointOnUnchangedByDefault)
{
  Actuator drive({}, 0.1, 5.0);
  EXPECT_EQ(drive.output(0.0, ANY), 0.1);
  EXPECT_EQ(drive.nextTime(), NEVER);
  drive.ask(0.3, 7.0);
  EXPECT_EQ(drive.nextTime(), 7.0);
  drive.advanceTo(7.0);
  EXPECT_EQ(drive.output(0.0, ANY), 0.3);
  EXPECT_EQ(drive.nextTime(), NEVER);
}

TEST(Actuator, HasADeadTimeInWhichItKeepsAllSetpoints)
{
  DriveSettings settings;
  settings.dead_time = 2.0;
  Actuator drive(settings, 0.0, 0.0);
  drive.ask(0.1, 1.0);
  drive.ask(0.2, 1.5);
  EXPECT_EQ(drive.asked(), 0.2);
  EXPECT_EQ(drive.nextTime(), 3.0);
  come(drive, 3.4);
  EXPECT_EQ(drive.output(0.0, ANY), 0.1);
  come(drive, 3.5);
  EXPECT_EQ(drive.output(0.0, ANY), 0.2);
}

TEST(Actuator, LagsExponentiallyAndArrives)
{
  DriveSettings settings;
  settings.time_constant = 0.5;
  Actuator drive(settings, 1.0, 0.0);
  drive.ask(3.0, 0.0);
  come(drive, 0.5);
  EXPECT_NEAR(drive.output(0.0, ANY), 3.0 - 2.0 * std::exp(-1.0), 2.0 * 0.05);  // within a step
  // Another goal on the way: from where it is then, not from its last step.
  const double then = 0.512;
  drive.ask(0.0, then);
  drive.advanceTo(then);
  EXPECT_NEAR(drive.output(0.0, ANY), 3.0 - 2.0 * std::exp(-then / 0.5), 1e-12);
  come(drive, 10.0);
  EXPECT_EQ(drive.output(0.0, ANY), 0.0);
  EXPECT_EQ(drive.nextTime(), NEVER);
}

TEST(Actuator, HasAResolutionAnOffsetAndLimits)
{
  EXPECT_DOUBLE_EQ(outputOf({0.0, 0.0, 0.1, {}, 0.0}, 0.26), 0.3);
  EXPECT_DOUBLE_EQ(outputOf({0.0, 0.0, 0.1, {}, 0.02}, 0.26), 0.32);
  EXPECT_EQ(outputOf({0.0, 0.0, 0.0, {}, 9.0}, 2.0), ANY.max);
}

TEST(Drives, GiveLessAmplitudeAtAnotherFrequency)
{
  DriveParameters parameters;
  parameters[indexOf(Quantity::AMPLITUDE)].over_frequency = {{20.0, 1.0}, {40.0, 0.5}};
  BaseDefinition base;
  base.frequency = 10.0;
  base.amplitude = 0.002;
  Drives drives(parameters, base, 0.0);
  EXPECT_EQ(drives.output(Quantity::AMPLITUDE), 0.002);
  for (const auto& [frequency, factor] : {std::pair(20.0, 1.0), {30.0, 0.75}, {40.0, 0.5}, {60.0, 0.5}})
  {
    drives.ask(Quantity::FREQUENCY, frequency, 1.0);
    drives.advanceTo(1.0);
    EXPECT_DOUBLE_EQ(drives.output(Quantity::AMPLITUDE), factor * 0.002);
  }
}

TEST(Drives, StayWhereTheyAreHeld)
{
  Drives drives({}, BaseDefinition(), 0.0);
  drives.setFault(Quantity::INCLINATION, "stuck", 0.07);
  drives.ask(Quantity::INCLINATION, 0.2, 1.0);
  drives.advanceTo(1.0);
  EXPECT_EQ(drives.output(Quantity::INCLINATION), 0.07);
  drives.setFault(Quantity::INCLINATION, "none", 0.07);
  EXPECT_EQ(drives.output(Quantity::INCLINATION), 0.2);
}

}  // namespace
}  // namespace ratchet_sieve
