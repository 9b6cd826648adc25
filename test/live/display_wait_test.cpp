#include <gtest/gtest.h>

#include "ratchet_sieve/live/display_wait.h"

namespace ratchet_sieve
{
namespace
{
DisplayWait::Clock::time_point at(double seconds)
{
  return DisplayWait::Clock::time_point() + std::chrono::milliseconds(static_cast<int>(1000.0 * seconds));
}

TEST(DisplayWait, waitsForNothingUnlessTold)
{
  DisplayWait wait(0.0);
  EXPECT_FALSE(wait.update(false, at(0.0)));
  EXPECT_FALSE(wait.waiting());
}

TEST(DisplayWait, endsWhenSomebodyWatchesAndSaysSoOnce)
{
  DisplayWait wait(60.0);
  EXPECT_TRUE(wait.waiting());
  EXPECT_EQ(wait.update(false, at(1.0)),
            "the run waits for a subscriber to ~markers or ~cloud, for at most 60 s");
  EXPECT_FALSE(wait.update(false, at(2.0)));
  EXPECT_TRUE(wait.waiting());
  EXPECT_EQ(wait.update(true, at(3.5)), "a display has subscribed after 2.5 s: the wait is over");
  EXPECT_FALSE(wait.waiting());
  // A display that disconnects again does not stop the run.
  EXPECT_FALSE(wait.update(false, at(4.0)));
  EXPECT_FALSE(wait.waiting());
}

TEST(DisplayWait, endsWhereNobodyComes)
{
  DisplayWait wait(60.0);
  wait.update(false, at(0.0));
  EXPECT_FALSE(wait.update(false, at(59.0)));
  EXPECT_TRUE(wait.waiting());
  EXPECT_EQ(wait.update(false, at(60.0)),
            "no subscriber to ~markers or ~cloud after 60 s (~wait_for_display): the wait is over");
  EXPECT_FALSE(wait.waiting());
}
}  // namespace
}  // namespace ratchet_sieve
