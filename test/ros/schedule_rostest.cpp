#include <algorithm>

#include <gtest/gtest.h>

#include "sieve_client.h"

namespace ratchet_sieve
{
namespace
{
/// The first time at which the base's frames show a command; nothing if none does.
std::optional<double> commandedAt(const std::vector<BaseFrame>& frames, double DriveState::*commanded,
                                  double value)
{
  for (const BaseFrame& frame : frames)
    if (frame.base.*commanded == value)
      return frame.time;
  return std::nullopt;
}

/// The sieve was started paused; the schedule unpauses it.
TEST(Schedule, commandsTheRunningSieveInTime)
{
  SieveClient sieve("/sieve");
  ASSERT_TRUE(waitFor([&] { return !sieve.base.frames.empty() && sieve.base.frames.back().time >= 2.0; }));
  const auto tilted = commandedAt(sieve.base.frames, &DriveState::commanded_inclination, 0.05);
  const auto slowed = commandedAt(sieve.base.frames, &DriveState::commanded_frequency, 20.0);
  const auto shrunk = commandedAt(sieve.base.frames, &DriveState::commanded_amplitude, 0.0015);
  ASSERT_TRUE(tilted && slowed && shrunk);
  EXPECT_GE(*tilted, 0.5);
  EXPECT_LE(*tilted, *slowed);
  EXPECT_GE(*slowed, 1.0);
  EXPECT_GE(*shrunk, 1.0);
}

/// Time jumps back, the base is at its initial state, and is commanded again.
TEST(Schedule, playsAgainAfterAReset)
{
  SieveClient sieve("/sieve");
  ASSERT_TRUE(sieve.connect());
  sieve.forget();
  ASSERT_TRUE(sieve.reset().success);
  ASSERT_TRUE(waitFor(
      [&] { return commandedAt(sieve.base.frames, &DriveState::commanded_inclination, 0.0).has_value(); }));
  const auto levelled =
      std::find_if(sieve.base.frames.begin(), sieve.base.frames.end(),
                   [](const BaseFrame& frame) { return frame.base.commanded_inclination == 0.0; });
  sieve.base.frames.erase(sieve.base.frames.begin(), levelled);
  const auto tilted = [&]
  { return commandedAt(sieve.base.frames, &DriveState::commanded_inclination, 0.05); };
  ASSERT_TRUE(waitFor([&] { return tilted().has_value(); }));
  EXPECT_GE(*tilted(), 0.5);
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "schedule_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
