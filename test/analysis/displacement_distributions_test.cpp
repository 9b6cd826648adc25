#include "ratchet_sieve/analysis/displacement_distributions.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hand_made_frames.h"

namespace ratchet_sieve
{
namespace
{

using Distributions = std::vector<DisplacementDistribution>;

TEST(DisplacementDistributions, AreTakenAtTheirTimesAndAtTheEnd)
{
  DisplacementDistributions distributions(1, {1.0, 2.0});
  for (int k = 0; k <= 12; ++k)
    distributions.take(particlesAt(k * 0.25, {diskAt(0, 0, 0.1 * k)}));
  std::vector<double> times;
  for (const DisplacementDistribution& distribution : distributions.distributions())
    times.push_back(distribution.time);
  EXPECT_EQ(times, (std::vector<double>{1.0, 2.0, 3.0}));
}

TEST(DisplacementDistributions, OfARunThatEndsOnATimeHaveThatTimeOnce)
{
  DisplacementDistributions distributions(1, {1.0});
  distributions.take(particlesAt(0.0, {diskAt(0, 0, 0.0)}));
  distributions.take(particlesAt(1.0, {diskAt(0, 0, 0.1)}));
  EXPECT_EQ(distributions.distributions().size(), 1u);
}

TEST(DisplacementDistributions, TakeOneFrameForTimesThatWerePassedOver)
{
  DisplacementDistributions distributions(1, {1.0, 2.0, 3.0});
  distributions.take(particlesAt(2.5, {diskAt(0, 0, 0.0)}));
  distributions.take(particlesAt(3.5, {diskAt(0, 0, 0.0)}));
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
    distributions.take(particlesAt(0.0, {diskAt(0, 0, low), diskAt(1, 0, high)}));
    const Distributions all = distributions.distributions();
    ASSERT_EQ(all.size(), 1u);
    EXPECT_EQ(all[0].total(), 2u);
    EXPECT_LE(all[0].counts.size(), 202u);
    EXPECT_GT(all[0].bin_width, 0.0);
  }
}

TEST(DisplacementDistributions, PutEachDiskIntoItsBin)
{
  DisplacementDistributions distributions(2, {0.0});
  distributions.take(particlesAt(0.0, {diskAt(0, 0, -0.5), diskAt(1, 0, -0.49), diskAt(2, 1, 0.5)}));
  const Distributions all = distributions.distributions();
  ASSERT_EQ(all.size(), 2u);
  EXPECT_DOUBLE_EQ(all[0].bin_width, 0.1);
  EXPECT_DOUBLE_EQ(all[0].first_edge, -0.5);
  ASSERT_EQ(all[0].counts.size(), 11u);
  EXPECT_EQ(all[0].counts[0], 2u);
  EXPECT_EQ(all[1].counts[10], 1u);
  EXPECT_DOUBLE_EQ(all[0].density(0), 10.0);
}

TEST(DisplacementDistributions, LeaveOutSpeciesWithoutADisk)
{
  DisplacementDistributions distributions(3, {0.0});
  distributions.take(particlesAt(0.0, {diskAt(0, 1, 0.5)}));
  const Distributions all = distributions.distributions();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].species, 1u);
}

TEST(DisplacementDistributions, OfNoDiskAreNone)
{
  DisplacementDistributions distributions(1, {0.0});
  EXPECT_TRUE(distributions.distributions().empty());
  distributions.take(particlesAt(0.0, {}));
  EXPECT_TRUE(distributions.distributions().empty());
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
  distributions.take(particlesAt(0.0, disks));
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
