#include "ratchet_sieve/analysis/displacements.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hand_made_result.h"

namespace ratchet_sieve
{
namespace
{

TEST(DisplacementTracker, GivesDisplacementOverTime)
{
  DisplacementTracker tracker(2, 0.0, true);
  tracker.add(particlesAt(0.0, {diskAt(0, 0, 0.0), diskAt(1, 0, 0.0), diskAt(2, 1, 0.0)}));
  tracker.add(particlesAt(2.0, {diskAt(0, 0, 1.0), diskAt(1, 0, 3.0), diskAt(2, 1, -4.0)}));
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
    tracker.add(particlesAt(0.1 * k, {diskAt(0, 0, displacement), diskAt(1, 0, displacement)}));
  }
  return tracker.velocities()[0];
}

TEST(DisplacementTracker, SeesDisksThatMoveTogetherUnlessTheyAreIndependent)
{
  EXPECT_NEAR(swinging(true).mean_stderr.value(), 0.0, 1e-9);
  // The difference of two sines at random phases, over 64 s: 1/64 m/s.
  EXPECT_NEAR(swinging(false).mean_stderr.value(), 1.0 / 64.0, 0.005);
  EXPECT_EQ(swinging(false).mean, swinging(true).mean);
}

TEST(DisplacementTracker, WeighsDisksByTheirTime)
{
  // 1 m in 1 s, and 1 m in 3 s: 2 m in 4 s.
  DisplacementTracker tracker(1, 0.0, true);
  tracker.add(particlesAt(0.0, {diskAt(0, 0, 0.0), diskAt(1, 0, 0.0)}));
  tracker.add(particlesAt(1.0, {diskAt(0, 0, 1.0), diskAt(1, 0, 0.0)}));
  tracker.add(particlesAt(3.0, {diskAt(1, 0, 1.0)}));
  EXPECT_DOUBLE_EQ(tracker.velocities()[0].mean.value(), 0.5);
}

TEST(DisplacementTracker, CountsNothingBeforeSettle)
{
  DisplacementTracker tracker(1, 1.0, true);
  tracker.add(particlesAt(0.0, {diskAt(0, 0, 0.0)}));
  tracker.add(particlesAt(1.0, {diskAt(0, 0, 10.0)}));
  tracker.add(particlesAt(3.0, {diskAt(0, 0, 11.0)}));
  EXPECT_DOUBLE_EQ(tracker.velocities()[0].mean.value(), 0.5);
}

TEST(DisplacementTracker, LeavesUndefinedWhatWasSeenOnce)
{
  DisplacementTracker tracker(1, 0.0, true);
  tracker.add(particlesAt(0.0, {diskAt(0, 0, 1.0)}));
  EXPECT_EQ(tracker.velocities()[0].disks, 0u);
  EXPECT_FALSE(tracker.velocities()[0].mean);
  EXPECT_FALSE(tracker.velocities()[0].mean_stderr);
}

using Distributions = std::vector<DisplacementDistribution>;

TEST(DisplacementDistributions, TakeOneFrameForTimesThatWerePassedOver)
{
  DisplacementDistributions distributions(1, {1.0, 2.0, 3.0});
  distributions.add(particlesAt(2.5, {diskAt(0, 0, 0.0)}));
  distributions.add(particlesAt(3.5, {diskAt(0, 0, 0.0)}));
  const Distributions all = distributions.distributions();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].time, 2.5);
  EXPECT_EQ(all[1].time, 3.5);
}

TEST(DisplacementDistributions, HaveFewBinsHoweverNearOrFarTheDisplacements)
{
  for (const auto& [low, high] :
       {std::pair(-1e15, 1e15), std::pair(1e15, 1e15 + 0.125), std::pair(0.0, 5e-324),
        std::pair(-5e-324, 5e-324), std::pair(0.1, std::nextafter(0.1, 1.0))})
  {
    DisplacementDistributions distributions(1, {0.0});
    distributions.add(particlesAt(0.0, {diskAt(0, 0, low), diskAt(1, 0, high)}));
    const Distributions all = distributions.distributions();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].total(), 2u);
    EXPECT_LE(all[0].counts.size(), 202u);
    EXPECT_GT(all[0].bin_width, 0.0);
  }
}

TEST(DisplacementDistributions, PutEachDiskIntoItsBin)
{
  DisplacementDistributions distributions(3, {0.0});
  distributions.add(particlesAt(0.0, {diskAt(0, 0, -0.5), diskAt(1, 0, -0.49), diskAt(2, 2, 0.5)}));
  const Distributions all = distributions.distributions();
  ASSERT_EQ(all.size(), 2u) << "species 1 has no disk";
  EXPECT_EQ(all[1].species, 2u);
  EXPECT_DOUBLE_EQ(all[0].bin_width, 0.1);
  EXPECT_DOUBLE_EQ(all[0].first_edge, -0.5);
  ASSERT_EQ(all[0].counts.size(), 11u);
  EXPECT_EQ(all[0].counts[0], 2u);
  EXPECT_EQ(all[1].counts[10], 1u);
  EXPECT_DOUBLE_EQ(all[0].density(0), 10.0);
}

TEST(DisplacementDistributions, OfNoDiskAreNone)
{
  DisplacementDistributions distributions(1, {0.0});
  EXPECT_TRUE(distributions.distributions().empty());
  distributions.add(particlesAt(0.0, {}));
  EXPECT_TRUE(distributions.distributions().empty());
}

TEST(DisplacementDistributions, CountWhatIsNoNumber)
{
  for (const double odd : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    DisplacementDistributions distributions(1, {0.0});
    distributions.add(particlesAt(0.0, {diskAt(0, 0, odd), diskAt(1, 0, 1.0), diskAt(2, 0, -1.0)}));
    EXPECT_EQ(distributions.distributions().at(0).total(), 3u);
  }
}

RC_GTEST_PROP(DisplacementDistributions, CountEveryDiskWithinTheEdges, ())
{
  const auto displacements =
      *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(-100000, 100000)));
  const double unit = *rc::gen::element(1e-9, 1e-6, 1e-3, 1.0, 7.0);
  std::vector<DiskState> disks;
  for (const int displacement : displacements)
    disks.push_back(diskAt(static_cast<std::uint32_t>(disks.size()), 0, unit * displacement));
  DisplacementDistributions distributions(1, {0.0});
  distributions.add(particlesAt(0.0, disks));
  const DisplacementDistribution distribution = distributions.distributions().at(0);

  RC_ASSERT(distribution.total() == disks.size());
  RC_ASSERT(distribution.counts.size() <= 202u);
  double integral = 0.0;
  for (std::size_t bin = 0; bin < distribution.counts.size(); ++bin)
  {
    integral += distribution.density(bin) * distribution.bin_width;
    const auto inside = std::count_if(disks.begin(), disks.end(),
                                      [&](const DiskState& disk)
                                      {
                                        const double slack = 1e-6 * distribution.bin_width;
                                        return disk.displacement >= distribution.edge(bin) - slack &&
                                               disk.displacement <= distribution.edge(bin + 1) + slack;
                                      });
    RC_ASSERT(distribution.counts[bin] <= static_cast<std::uint64_t>(inside));
  }
  RC_ASSERT(std::abs(integral - 1.0) < 1e-9);
}

}  // namespace
}  // namespace ratchet_sieve
