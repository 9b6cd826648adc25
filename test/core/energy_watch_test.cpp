// A run whose disks are heated without limit is reported with figures; a dissipative run is not.
#include "state/energy_watch.h"

#include <functional>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// Single disks over one driven tooth.
SceneDefinition driven(double restitution)
{
  SceneDefinition scene = test::singleParticles(20);
  scene.base.teeth = 1;
  scene.pour.drop_height = 0.001;
  scene.species[0].contact = {restitution, 0.0, 0.0};
  scene.contact.min_rebound_speed = restitution < 1.0 ? 0.05 : 0.0;
  return scene;
}

/// Fermi acceleration: the mean square speed grows with each bounce.
TEST(EnergyWatch, SaysThatElasticDisksOnADrivenBaseHeatUp)
{
  Simulation simulation(driven(1.0));
  simulation.advanceTo(100.0);
  EXPECT_FALSE(simulation.implausibleEnergy());
  simulation.advanceTo(20000.0);
  EXPECT_GT(simulation.largestEnergy(), EnergyWatch::ALARM);
  ASSERT_TRUE(simulation.implausibleEnergy());
  EXPECT_GT(simulation.implausibleEnergy()->scales, EnergyWatch::ALARM);
  EXPECT_GT(simulation.implausibleEnergy()->energy, 0.0);
}

TEST(EnergyWatch, SaysNothingWhereCollisionsLoseWhatTheDriveGives)
{
  Simulation single(driven(0.9));
  single.advanceTo(20000.0);
  EXPECT_FALSE(single.implausibleEnergy());
  EXPECT_LT(single.largestEnergy(), 50.0);

  SceneDefinition scene = test::mixture(60);
  scene.base.teeth = 5;
  Simulation mixture(scene);
  mixture.advanceTo(2.0);
  EXPECT_FALSE(mixture.implausibleEnergy());
  EXPECT_GT(mixture.largestEnergy(), 0.0);
  EXPECT_LT(mixture.largestEnergy(), 5.0);
}

/// On an endless slope a disk falls forever: v = g t sin(theta), so that its energy per mass is (1/2) (g t
/// sin(theta))^2.
TEST(EnergyWatch, NamesTheFirstDiskAndTheTimeAndGoesOnFromASavedState)
{
  SceneDefinition scene = driven(0.6);
  scene.base.inclination = 1.5;
  Simulation simulation(scene);
  simulation.advanceTo(40.0);
  ASSERT_TRUE(simulation.implausibleEnergy());
  const LargeEnergy first = *simulation.implausibleEnergy();
  const double largest = simulation.largestEnergy();
  simulation.advanceTo(80.0);
  EXPECT_GT(simulation.largestEnergy(), largest);

  const Simulation resumed(scene, simulation.saveState());
  EXPECT_EQ(resumed.largestEnergy(), simulation.largestEnergy());
  for (const Simulation& run : {std::cref(simulation), std::cref(resumed)})
  {
    EXPECT_EQ(run.implausibleEnergy()->time, first.time);
    EXPECT_EQ(run.implausibleEnergy()->disk, first.disk);
    EXPECT_EQ(run.implausibleEnergy()->energy, first.energy);
  }
}

}  // namespace
}  // namespace ratchet_sieve
