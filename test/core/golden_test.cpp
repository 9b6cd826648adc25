#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

/// The bits of a run, the same on every machine, with every compiler and at every optimisation
/// level. A change of the engine that changes them is a change of results: say so in the CHANGELOG.
TEST(Golden, Ensemble)
{
  Simulation simulation(test::singleParticles(50));
  simulation.advanceTo(10.0);
  EXPECT_EQ(test::stateHash(simulation), 9181331720100110990ull);
}

TEST(Golden, Mixture)
{
  SceneDefinition scene = test::mixture(60);
  scene.base.teeth = 5;
  scene.base.inclination = 0.052;
  Simulation simulation(scene);
  simulation.advanceTo(2.0);
  EXPECT_EQ(test::stateHash(simulation), 18277699463035252649ull);
}

/// So many disks that what the next events need is fetched ahead.
TEST(Golden, LargeMixture)
{
  SceneDefinition scene = test::mixture(16000);
  scene.base.teeth = 1221;
  Simulation simulation(scene);
  simulation.advanceTo(0.08);
  EXPECT_GT(simulation.collisions().total(), 50000u);
  EXPECT_EQ(test::stateHash(simulation), 15708961260521173016ull);
}

TEST(Golden, SetpointsWhileItRuns)
{
  Simulation simulation(test::openMixture(30));
  simulation.advanceTo(1.0);
  simulation.command(Quantity::INCLINATION, 0.1);
  simulation.command(Quantity::FREQUENCY, 26.0);
  simulation.advanceTo(4.0);
  EXPECT_EQ(test::stateHash(simulation), 2012284987454928914ull);
}

}  // namespace
}  // namespace ratchet_sieve
