#include "ratchet_sieve/statistics/flow_series.h"

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

double sumOver(const std::vector<BlockSum>& blocks)
{
  double sum = 0.0;
  for (const BlockSum& block : blocks)
    sum += block.sum;
  return sum;
}

void expectFlowOfTheBins(bool pairs)
{
  SceneDefinition scene = test::fedSieve(pairs);
  scene.feed.even = false;  // No disk enters just when a block ends.
  Simulation simulation(scene);
  simulation.advanceTo(simulation.blockEnd(0));
  const std::vector<SpeciesBins> before = simulation.bins();
  std::vector<double> inside(2);
  const std::uint64_t blocks = 40;
  for (std::uint64_t k = 1; k <= blocks; ++k)
  {
    simulation.advanceTo(simulation.blockEnd(k));
    for (std::size_t s = 0; s < 2; ++s)
      inside[s] += static_cast<double>(simulation.bins()[s].on_base);
  }
  const FlowSeries series = simulation.flowSeries();
  EXPECT_EQ(series.start, 1.0);
  EXPECT_DOUBLE_EQ(series.block_time, (pairs ? 1.0 : 8.0) * simulation.timeScale());
  for (std::size_t s = 0; s < 2; ++s)
  {
    const SpeciesFlow& flow = series.species[s];
    const SpeciesBins now = simulation.bins()[s];
    ASSERT_EQ(flow.inside.size(), blocks);
    EXPECT_GT(now.left, before[s].left);
    EXPECT_EQ(sumOver(flow.left.number), static_cast<double>(now.left - before[s].left));
    EXPECT_EQ(sumOver(flow.right.number), static_cast<double>(now.right - before[s].right));
    EXPECT_NEAR(sumOver(flow.left.mass), now.left_mass - before[s].left_mass, 1e-12 * now.left_mass);
    EXPECT_DOUBLE_EQ(sumOver(flow.inside), inside[s] * series.block_time);
    EXPECT_DOUBLE_EQ(flow.left.number.front().weight, series.block_time);
  }
}

TEST(FlowSeries, AddsUpToTheBinsSinceSettle)
{
  for (const bool pairs : {true, false})
    expectFlowOfTheBins(pairs);
}

TEST(FlowSeries, HasAFewHundredBlocks)
{
  SceneDefinition scene = test::fedSieve(false);
  scene.feed.rate = 1.0;
  Simulation simulation(scene);
  simulation.advanceTo(simulation.blockEnd(1500));
  const FlowSeries series = simulation.flowSeries();
  EXPECT_EQ(series.species[0].inside.size(), 375u);
  EXPECT_DOUBLE_EQ(series.block_time, 32.0 * simulation.timeScale());
}

TEST(FlowSeries, IsKeptOnlyWhereDisksAreFedAndCanLeave)
{
  SceneDefinition unfed = test::fedSieve(true);
  unfed.feed.rate = 0.0;
  SceneDefinition ring = test::fedSieve(false);
  ring.boundary = Boundary::PERIODIC;
  for (const SceneDefinition& scene : {unfed, ring})
  {
    Simulation simulation(scene);
    simulation.advanceTo(1.5);
    EXPECT_TRUE(simulation.flowSeries().species.empty());
  }
}

}  // namespace
}  // namespace ratchet_sieve
