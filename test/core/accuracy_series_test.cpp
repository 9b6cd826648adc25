#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition fedEnsemble()
{
  SceneDefinition scene = test::fedSieve(false);
  scene.accuracy.mean_vx = 1e-3;
  scene.accuracy.quality = 1e-3;
  return scene;
}

double ratioOf(const std::vector<BlockSum>& blocks)
{
  double sum = 0.0, weight = 0.0;
  for (const BlockSum& block : blocks)
  {
    sum += block.sum;
    weight += block.weight;
  }
  return sum / weight;
}

TEST(AccuracySeries, OfSingleDisksAddsUpToTheirMeans)
{
  Simulation simulation(fedEnsemble());
  const std::uint64_t blocks = 60;
  simulation.advanceTo(simulation.blockEnd(blocks));
  const MeanSeries series = simulation.meanSeries();
  const std::vector<SpeciesMeans> means = simulation.means();
  EXPECT_DOUBLE_EQ(series.block_time, 8.0 * simulation.timeScale());
  for (std::size_t s = 0; s < 2; ++s)
  {
    const SpeciesSeries& species = series.species[s];
    ASSERT_EQ(species.velocity.size(), blocks);
    EXPECT_EQ(species.groups.size(), 64u);
    EXPECT_NEAR(ratioOf(species.velocity), *means[s].mean_vx, 1e-9 * std::abs(*means[s].mean_vx));
  }
}

TEST(AccuracySeries, OfALayerAddsUpToItsMeans)
{
  SceneDefinition scene = test::mixture(10);
  scene.base.teeth = 3;
  scene.settle = 0.5;
  Simulation simulation(scene);
  simulation.advanceTo(simulation.blockEnd(100));
  const MeanSeries series = simulation.meanSeries();
  ASSERT_EQ(series.species[1].velocity.size(), 100u);
  EXPECT_NEAR(ratioOf(series.species[1].velocity), *simulation.means()[1].mean_vx, 1e-12);
  EXPECT_EQ(series.block_time, simulation.timeScale());
  simulation.advanceTo(simulation.blockEnd(512));
  EXPECT_EQ(simulation.meanSeries().species[0].velocity.size(), 256u);
  EXPECT_DOUBLE_EQ(simulation.meanSeries().block_time, 2.0 * simulation.timeScale());
}

TEST(AccuracySeries, OfASavedRunIsRefusedWhereItIsMissing)
{
  const SceneDefinition asking = fedEnsemble();
  SceneDefinition silent = asking;
  silent.accuracy = {};
  Simulation half(asking), unasked(silent);
  half.advanceTo(6.0);
  unasked.advanceTo(6.0);
  try
  {
    Simulation(asking, unasked.saveState());
    FAIL() << "not refused";
  }
  catch (const StateError& error)
  {
    EXPECT_STREQ(error.what(),
                 "it lacks the series for the requested accuracy, which its own scene did not request");
  }
  Simulation dropped(silent, half.saveState());
  EXPECT_EQ(dropped.saveState().size(), unasked.saveState().size());
}

}  // namespace
}  // namespace ratchet_sieve
