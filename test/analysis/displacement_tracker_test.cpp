#include "ratchet_sieve/analysis/displacement_tracker.h"

#include <cmath>

#include <gtest/gtest.h>

#include "hand_made_frames.h"

namespace ratchet_sieve
{
namespace
{

TEST(DisplacementTracker, GivesDisplacementOverTime)
{
  DisplacementTracker tracker(2, 0.0, true);
  tracker.take(particlesAt(0.0, {diskAt(0, 0, 0.0), diskAt(1, 0, 0.0), diskAt(2, 1, 0.0)}));
  tracker.take(particlesAt(2.0, {diskAt(0, 0, 1.0), diskAt(1, 0, 3.0), diskAt(2, 1, -4.0)}));
  const std::vector<DriftVelocity> velocities = tracker.velocities();
  EXPECT_DOUBLE_EQ(velocities[0].mean.value(), 1.0);
  // Velocities of 0.5 and 1.5: their standard deviation is sqrt(0.5), that of their mean 0.5.
  EXPECT_DOUBLE_EQ(velocities[0].mean_stderr.value(), 0.5);
  EXPECT_DOUBLE_EQ(velocities[1].mean.value(), -2.0);
  EXPECT_FALSE(velocities[1].mean_stderr);
}

/// Two disks that oscillate together about a mean velocity of 1 m/s.
DriftVelocity swinging(bool independent)
{
  DisplacementTracker tracker(1, 0.0, independent);
  for (int k = 0; k <= 640; ++k)
  {
    const double displacement = 0.1 * k + std::sin(0.5 * k);
    tracker.take(particlesAt(0.1 * k, {diskAt(0, 0, displacement), diskAt(1, 0, displacement)}));
  }
  return tracker.velocities()[0];
}

TEST(DisplacementTracker, SeesDisksThatMoveTogetherUnlessTheyAreIndependent)
{
  EXPECT_NEAR(swinging(true).mean_stderr.value(), 0.0, 1e-9);
  EXPECT_GT(swinging(false).mean_stderr.value(), 0.05);
  EXPECT_EQ(swinging(false).mean, swinging(true).mean);
}

TEST(DisplacementTracker, WeighsDisksByTheirTime)
{
  // 1 m in 1 s, and 1 m in 3 s: 2 m in 4 s.
  DisplacementTracker tracker(1, 0.0, true);
  tracker.take(particlesAt(0.0, {diskAt(0, 0, 0.0), diskAt(1, 0, 0.0)}));
  tracker.take(particlesAt(1.0, {diskAt(0, 0, 1.0), diskAt(1, 0, 0.0)}));
  tracker.take(particlesAt(3.0, {diskAt(1, 0, 1.0)}));
  EXPECT_DOUBLE_EQ(tracker.velocities()[0].mean.value(), 0.5);
}

TEST(DisplacementTracker, CountsNothingBeforeSettle)
{
  DisplacementTracker tracker(1, 1.0, true);
  tracker.take(particlesAt(0.0, {diskAt(0, 0, 0.0)}));
  tracker.take(particlesAt(1.0, {diskAt(0, 0, 10.0)}));
  tracker.take(particlesAt(3.0, {diskAt(0, 0, 11.0)}));
  EXPECT_DOUBLE_EQ(tracker.velocities()[0].mean.value(), 0.5);
}

TEST(DisplacementTracker, TakesDisksThatEnterLater)
{
  DisplacementTracker tracker(1, 0.0, true);
  tracker.take(particlesAt(0.0, {}));
  tracker.take(particlesAt(5.0, {diskAt(7, 0, 0.25)}));
  tracker.take(particlesAt(6.0, {diskAt(7, 0, 0.75)}));
  EXPECT_DOUBLE_EQ(tracker.velocities()[0].mean.value(), 0.5);
}

TEST(DisplacementTracker, LeavesUndefinedWhatWasSeenOnce)
{
  DisplacementTracker tracker(1, 0.0, true);
  tracker.take(particlesAt(0.0, {diskAt(0, 0, 1.0)}));
  EXPECT_EQ(tracker.velocities()[0].disks, 0u);
  EXPECT_FALSE(tracker.velocities()[0].mean);
  EXPECT_FALSE(tracker.velocities()[0].mean_stderr);
}

}  // namespace
}  // namespace ratchet_sieve
