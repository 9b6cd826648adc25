#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// Fig. 8's density over a quarter of its base.
SceneDefinition layer()
{
  SceneDefinition scene = test::mixture(65);
  scene.base.teeth = 5;
  scene.settle = 1.0;
  return scene;
}

double kinetic(const SpeciesMeans& means)
{
  return *means.kinetic_translational + *means.kinetic_rotational;
}

TEST(StepLoop, IsChosenByTheScene)
{
  EXPECT_FALSE(Simulation(layer()).plan().steps);
  const Simulation simulation(test::bySteps(layer(), 0.001));
  EXPECT_TRUE(simulation.plan().steps);
  EXPECT_FALSE(Simulation(test::bySteps(test::singleParticles(3), 0.001)).plan().steps);
}

/// A single disk that lands on a flat base overlaps it at the end of every step with a contact: no contact is
/// missed, and each is executed at its exact time.
TEST(StepLoop, MissesNoContactOfABouncingBall)
{
  SceneDefinition scene = test::mixture(0);
  scene.base.tooth_height = 0.0;
  scene.base.amplitude = 0.0;
  scene.species[0].contact.restitution = 0.9;
  InitialDisk disk;
  disk.x = 0.1;
  disk.y = 0.1;
  disk.vx = 0.2;
  scene.initial = {disk};
  Simulation exact(scene);
  Simulation stepped(test::bySteps(scene, 0.0037));
  exact.advanceTo(3.0);
  stepped.advanceTo(3.0);
  EXPECT_GT(exact.collisions().total(), 10u);
  EXPECT_EQ(stepped.collisions().total(), exact.collisions().total());
  EXPECT_NEAR(stepped.disks()[0].y, exact.disks()[0].y, 1e-9);
  EXPECT_NEAR(stepped.disks()[0].x, exact.disks()[0].x, 1e-9);
}

/// Bounds of docs/accuracy.md, for quantities that are known to 1 % after some seconds.
void expectErrors(const SceneDefinition& scene, double step, double of_energy, double of_rate)
{
  Simulation exact(scene);
  Simulation stepped(test::bySteps(scene, step));
  exact.advanceTo(25.0);
  stepped.advanceTo(25.0);
  EXPECT_LE(stepped.auditOverlaps(), 1u);
  for (std::size_t species : {0u, 1u})
  {
    const SpeciesMeans a = exact.means()[species];
    const SpeciesMeans b = stepped.means()[species];
    EXPECT_NEAR(kinetic(b), kinetic(a), of_energy * kinetic(a));
    EXPECT_NEAR(*b.collision_rate, *a.collision_rate, of_rate * *a.collision_rate);
    EXPECT_NEAR(*b.mean_vx, *a.mean_vx, 4.0 * std::hypot(*a.mean_vx_stderr, *b.mean_vx_stderr));
  }
}

TEST(StepLoop, HoldsItsErrorInAShakenLayer)
{
  expectErrors(layer(), 0.002, 0.03, 0.03);
  // The smallest disks need shorter steps, and between large ones they have many contacts in quick
  // succession.
  expectErrors(test::withSizes(layer()), 0.00025, 0.05, 0.1);
}

/// Contacts that leave no overlap are missed, and disks are found below the surface and moved out.
TEST(StepLoop, LosesNoDiskWhereStepsAreTooLong)
{
  SceneDefinition scene = test::bySteps(layer(), 0.02);
  Simulation simulation(scene);
  simulation.advanceTo(5.0);
  EXPECT_GT(simulation.pushedOut(), 0u);
  for (const DiskState& disk : simulation.disks())
    EXPECT_GT(disk.y, -0.05) << disk.id;
}

TEST(StepLoop, NeedsNoReboundFloorToComeToItsEnd)
{
  SceneDefinition scene = test::bySteps(layer(), 0.001);
  scene.contact.min_rebound_speed = 0.0;
  scene.base.amplitude = 0.0;
  Simulation simulation(scene);
  simulation.advanceTo(0.15);
  EXPECT_FALSE(simulation.stalled());
}

/// In a collapse, disks hardly move relative to each other, and rounding decides whether they approach.
/// Search and execution must use the same sum. With two different sums, a third of the predicted contacts
/// were found separating.
TEST(StepLoop, ExecutesEveryPairThatItFindsClosing)
{
  SceneDefinition scene = test::bySteps(layer(), 0.005);
  scene.contact.min_rebound_speed = 0.0;
  scene.base.amplitude = 0.0;
  scene.base.tooth_height = 0.0;
  for (SpeciesDefinition& species : scene.species)
    species.contact = {0.0, 0.0, 0.0};
  Simulation simulation(scene);
  simulation.advanceTo(0.12);
  EXPECT_GT(simulation.events(), 10000u);
  EXPECT_EQ(simulation.collisions().total(), simulation.events());
}

}  // namespace
}  // namespace ratchet_sieve
