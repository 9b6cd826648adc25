#include "ratchet_sieve/ros/schedule.h"

#include <string>

#include <gtest/gtest.h>

#include "ratchet_sieve/ros/parameter_reader.h"

namespace ratchet_sieve
{
namespace
{
std::string refusalOfSchedule(const std::string& yaml)
{
  try
  {
    scheduleFromYaml(YAML::Load(yaml), "schedule");
  }
  catch (const ParameterError& error)
  {
    return error.what();
  }
  return "taken";
}

TEST(Schedule, readsTimesAndWhatToCommand)
{
  const auto schedule = scheduleFromYaml(
      YAML::Load("[{time: 1, inclination: 0.1}, {time: 2.5, frequency: 25, amplitude: 0.001}]"), "schedule");
  ASSERT_EQ(schedule.size(), 2u);
  EXPECT_EQ(schedule[0].time, 1.0);
  EXPECT_EQ(schedule[0].values[0], 0.1);
  EXPECT_FALSE(schedule[0].values[1]);
  EXPECT_EQ(schedule[1].time, 2.5);
  EXPECT_FALSE(schedule[1].values[0]);
  EXPECT_EQ(schedule[1].values[1], 25.0);
  EXPECT_EQ(schedule[1].values[2], 0.001);
}

TEST(Schedule, refusesWhatItCannotFollow)
{
  EXPECT_EQ(refusalOfSchedule("{time: 1}"),
            "schedule: must be a list of {time, inclination, frequency, amplitude}");
  EXPECT_EQ(refusalOfSchedule("[{inclination: 1}]"), "schedule/0: must be a map with the key time");
  EXPECT_EQ(refusalOfSchedule("[{time: soon}]"), "schedule/0/time: must be a finite number");
  EXPECT_EQ(refusalOfSchedule("[{time: 1, angle: 2}]"),
            "schedule/0/angle: not known: must be time, inclination, frequency or amplitude");
  EXPECT_EQ(refusalOfSchedule("[{time: 1}]"),
            "schedule/0: commands nothing: must have inclination, frequency or amplitude");
  EXPECT_EQ(refusalOfSchedule("[{time: 2, frequency: 1}, {time: 1, frequency: 1}]"),
            "schedule/1/time: must not be before that of the entry above");
}
}  // namespace
}  // namespace ratchet_sieve
