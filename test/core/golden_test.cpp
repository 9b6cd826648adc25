#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

/// The bits of a run, the same on every machine, with every compiler and at every optimisation level. A
/// change of the engine that changes them changes results: mention it in the CHANGELOG.
TEST(Golden, Ensemble)
{
  Simulation simulation(test::singleParticles(50));
  simulation.advanceTo(10.0);
  EXPECT_EQ(test::stateHash(simulation), 13996360283402651741ull);
}

TEST(Golden, Mixture)
{
  SceneDefinition scene = test::mixture(60);
  scene.base.teeth = 5;
  scene.base.inclination = 0.052;
  Simulation simulation(scene);
  simulation.advanceTo(2.0);
  EXPECT_EQ(test::stateHash(simulation), 17057333013311561752ull);
}

/// Enough disks for the prefetching of the next events.
TEST(Golden, LargeMixture)
{
  SceneDefinition scene = test::mixture(16000);
  scene.base.teeth = 1221;
  Simulation simulation(scene);
  simulation.advanceTo(0.08);
  EXPECT_GT(simulation.collisions().total(), 50000u);
  EXPECT_EQ(test::stateHash(simulation), 14543616183556555083ull);
}

TEST(Golden, SetpointsWhileItRuns)
{
  Simulation simulation(test::openMixture(30));
  simulation.advanceTo(1.0);
  simulation.command(Quantity::INCLINATION, 0.1);
  simulation.command(Quantity::FREQUENCY, 26.0);
  simulation.advanceTo(4.0);
  EXPECT_EQ(test::stateHash(simulation), 17874495602983085652ull);
}

/// The seam of a periodic base that turns, with and without disk-disk collisions.
TEST(Golden, RingsThatTurn)
{
  const auto hash = [](const SceneDefinition& scene)
  {
    Simulation simulation(scene);
    for (const double setpoint : {0.1, -0.05, 0.0})
    {
      simulation.command(Quantity::INCLINATION, setpoint);
      simulation.advanceTo(simulation.time() + 0.7);
    }
    return test::stateHash(simulation);
  };
  SceneDefinition ring = test::mixture(30);
  ring.base.teeth = 3;
  EXPECT_EQ(hash(ring), 260470586789521152ull);
  ring.contact.pair_collisions = false;
  EXPECT_EQ(hash(ring), 7227758289409880391ull);
}

/// Setpoints that arrive within steps, on both kinds of base.
TEST(Golden, StepsWithSetpointsWhileTheyRun)
{
  const auto hash = [](const SceneDefinition& scene)
  {
    Simulation simulation(test::bySteps(scene, 0.0013));
    simulation.advanceTo(0.5);
    simulation.command(Quantity::INCLINATION, 0.1);
    simulation.command(Quantity::FREQUENCY, 26.0);
    simulation.advanceTo(2.0);
    EXPECT_GT(simulation.collisions().disk_disk, 1000u);
    return test::stateHash(simulation);
  };
  SceneDefinition ring = test::mixture(60);
  ring.base.teeth = 5;
  EXPECT_EQ(hash(ring), 9745999892235013113ull);
  EXPECT_EQ(hash(test::openMixture(30)), 9114443768208467886ull);
}

}  // namespace
}  // namespace ratchet_sieve
