#include <algorithm>

#include <gtest/gtest.h>

#include "sieve_client.h"

namespace ratchet_sieve
{
namespace
{
/// The demo as launched, but faster: first level, then tilted by its schedule.
TEST(Demo, separatesTheMixtureUnderCommand)
{
  SieveClient sieve("/sieve");
  ASSERT_TRUE(sieve.connect());
  const double duration = 30.0;
  ASSERT_TRUE(sieve.bins.waitForTime(duration));
  ASSERT_TRUE(sieve.base.waitForTime(duration));
  const auto reached = [&](double DriveState::*quantity, double value)
  {
    return std::any_of(sieve.base.frames.begin(), sieve.base.frames.end(),
                       [=](const BaseFrame& frame) { return frame.base.*quantity == value; });
  };
  EXPECT_TRUE(reached(&DriveState::inclination, 0.19));
  EXPECT_TRUE(reached(&DriveState::frequency, 26.0));

  const BinFrame& last = sieve.bins.frames.back();
  ASSERT_TRUE(last.quality && last.processed);
  EXPECT_GT(*last.processed, 0.9);
  EXPECT_GT(*last.quality, 0.5);
  // Small and heavy to the right, large and light to the left.
  EXPECT_GT(last.bins.at(0).right, last.bins.at(0).left);
  EXPECT_GT(last.bins.at(1).left, last.bins.at(1).right);
}
}  // namespace
}  // namespace ratchet_sieve

int main(int argc, char** argv)
{
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "demo_rostest");
  const ros::NodeHandle node;
  return RUN_ALL_TESTS();
}
