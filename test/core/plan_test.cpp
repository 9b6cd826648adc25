#include "ratchet_sieve/core/plan.h"

#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition smallMixture()
{
  SceneDefinition scene = test::mixture(20);
  scene.base.teeth = 5;
  return scene;
}

SceneDefinition smooth(SceneDefinition scene)
{
  for (SpeciesDefinition& species : scene.species)
    species.contact.friction = 0.0;
  return scene;
}

/// The same scene for more of the model: a species that no disk is of has friction, and no contact is within
/// this duration of another.
SceneDefinition askingForMore(SceneDefinition scene)
{
  scene.species.push_back(test::smallDisk(0));
  scene.contact.contact_duration = 1e-300;
  return scene;
}

TEST(Plan, HasSpinOnlyWhereFrictionTurnsADiskOrOneStartsWithIt)
{
  SceneDefinition scene = smooth(smallMixture());
  EXPECT_FALSE(planOf(scene).spin);

  SceneDefinition rough = scene;
  rough.species[1].contact.friction = 0.1;
  EXPECT_TRUE(planOf(rough).spin);
  for (SpeciesDefinition& species : rough.species)
    species.contact.tangential_restitution = -1.0;
  EXPECT_FALSE(planOf(rough).spin) << "a contact that keeps all of the tangential velocity is smooth";
  rough.species[0].contact.tangential_restitution = 0.4;
  EXPECT_TRUE(planOf(rough).spin) << "the mean of the two has friction and gives back";
  rough.contact.pair_collisions = false;
  EXPECT_FALSE(planOf(rough).spin);

  SceneDefinition rough_pair = scene;
  rough_pair.pairs = {{0, 1, {0.6, 0.1, 0.4}}};
  EXPECT_TRUE(planOf(rough_pair).spin);

  SceneDefinition spinning = scene;
  spinning.initial = {{0, 0.01, 0.02, 0.0, 0.0, -3.0}};
  EXPECT_TRUE(planOf(spinning).spin);
  spinning.initial[0].spin = 0.0;
  EXPECT_FALSE(planOf(spinning).spin);
}

TEST(Plan, HasADriveOnlyWhereTheBaseMoves)
{
  SceneDefinition scene = smallMixture();
  scene.base.amplitude = 0.0;
  EXPECT_FALSE(planOf(scene).drive);
  scene = smallMixture();
  scene.base.frequency = 0.0;
  EXPECT_FALSE(planOf(scene).drive);
}

TEST(Plan, HasAnOrbitAndNoSimdWhereTheDriveIsMoreThanASine)
{
  SceneDefinition scene = test::singleParticles(10);
  EXPECT_TRUE(planOf(scene).simd && !planOf(scene).orbit);
  scene.base.horizontal_phase = 1.0;
  scene.base.harmonics = {{2, 0.0, 1.0, 0.0, 1.0}};
  EXPECT_TRUE(planOf(scene).simd && !planOf(scene).orbit) << "phases alone move nothing";
  SceneDefinition oblique = scene;
  oblique.base.horizontal_amplitude = -1e-4;
  SceneDefinition harmonic = scene;
  harmonic.base.harmonics[0].amplitude = 1e-4;
  for (SceneDefinition& driven : std::vector<SceneDefinition>{oblique, harmonic})
  {
    EXPECT_TRUE(planOf(driven).orbit && !planOf(driven).simd);
    driven.base.amplitude = 0.0;
    EXPECT_TRUE(planOf(driven).drive);
  }
}

TEST(Plan, HasSimdOnlyForSingleDisksOnAPeriodicBaseWithoutContactTimes)
{
  const SceneDefinition singles = test::singleParticles(5);
  EXPECT_TRUE(planOf(singles).simd);
  EXPECT_FALSE(planOf(smallMixture()).simd);
  std::vector<SceneDefinition> others(3, singles);
  others[0].boundary = Boundary::OPEN;
  others[1].boundary = Boundary::WALLED;
  others[2].contact.contact_duration = 1e-4;
  for (const SceneDefinition& scene : others)
    EXPECT_FALSE(planOf(scene).simd);
}

void runThrough(Simulation& simulation)
{
  simulation.setSlewRates({0.3, 40.0, 0.004});
  simulation.advanceTo(1.5);
  simulation.command(Quantity::INCLINATION, 0.05);
  simulation.pour(0, 3);
  simulation.advanceTo(3.0);
}

void expectTheSameBits(const SceneDefinition& scene)
{
  Simulation lean(scene);
  Simulation full(askingForMore(scene));
  EXPECT_TRUE(full.plan().spin && full.plan().contact_times);
  runThrough(lean);
  runThrough(full);
  EXPECT_GT(lean.collisions().total(), 100u);
  EXPECT_EQ(lean.events(), full.events());
  EXPECT_EQ(test::stateHash(lean), test::stateHash(full));
  EXPECT_EQ(lean.baseImpulse().x(), full.baseImpulse().x());
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    EXPECT_EQ(lean.means()[i].mean_vx, full.means()[i].mean_vx);
    EXPECT_EQ(lean.means()[i].kinetic_translational, full.means()[i].kinetic_translational);
    EXPECT_EQ(lean.means()[i].kinetic_rotational, full.means()[i].kinetic_rotational);
  }
}

/// The plan of every scene in this test leaves out something, but not SIMD, which round differently.
TEST(Plan, LeavesOutWhatChangesNoBit)
{
  for (const bool pairs : {true, false})
  {
    SceneDefinition scene = smallMixture();
    scene.boundary = pairs ? Boundary::PERIODIC : Boundary::WALLED;
    scene.contact.pair_collisions = pairs;
    scene.contact.min_rebound_speed = 0.1;
    expectTheSameBits(scene);
    expectTheSameBits(smooth(scene));
  }
}

}  // namespace
}  // namespace ratchet_sieve
