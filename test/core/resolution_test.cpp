#include "ratchet_sieve/core/resolution.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

TEST(Resolution, TimeScaleIsTheShortestThatTheSceneHas)
{
  SceneDefinition scene = test::mixture(1);
  scene.contact.min_rebound_speed = 0.0;
  EXPECT_DOUBLE_EQ(timeScale(scene), 1.0 / 23.0);
  scene.base.frequency = 1.0;
  EXPECT_DOUBLE_EQ(timeScale(scene), std::sqrt(0.020 / 9.81));
  scene.pour.speed = 2.0;
  EXPECT_DOUBLE_EQ(timeScale(scene), 0.010);
  scene.initial = {{0, 0.1, 0.1, 3.0, -4.0, 0.0}};
  EXPECT_DOUBLE_EQ(timeScale(scene), 0.004);
}

TEST(Resolution, OfASceneInWhichNothingMovesIsASecond)
{
  SceneDefinition scene = test::mixture(1);
  scene.contact.min_rebound_speed = 0.0;
  scene.base.frequency = 0.0;
  scene.gravity = 0.0;
  EXPECT_EQ(timeScale(scene), 1.0);
}

TEST(Resolution, TheLongestEpochKeepsAFastBaseFromOverlapping)
{
  const double length = longestEpoch(100.0, 1e-6);
  EXPECT_LE(100.0 * timeResolution(length), 0.5e-9 * 1e-6);
  EXPECT_GT(100.0 * timeResolution(2.0 * length), 0.5e-9 * 1e-6);
  EXPECT_EQ(std::exp2(std::round(std::log2(length))), length);
  EXPECT_EQ(longestEpoch(0.0, 1e-6), std::numeric_limits<double>::infinity());
}

TEST(Resolution, TheLongestFallKeepsAFastDiskFromOverlapping)
{
  const double length = longestFall(9.81, 1e-6);
  EXPECT_LE(9.81 * length * timeResolution(length), 0.05e-9 * 1e-6);
  EXPECT_GT(9.81 * 2.0 * length * timeResolution(2.0 * length), 0.05e-9 * 1e-6);
  EXPECT_EQ(std::exp2(std::round(std::log2(length))), length);
  EXPECT_EQ(longestFall(0.0, 1e-6), std::numeric_limits<double>::infinity());
}

TEST(Resolution, AnEpochIsAPowerOfTwoOfEightTimeScalesOrMore)
{
  EXPECT_EQ(epochLength(1.0), 8.0);
  EXPECT_EQ(epochLength(1.01), 16.0);
  EXPECT_EQ(epochLength(1.0 / 23.0), 0.5);
}

}  // namespace
}  // namespace ratchet_sieve
