// A run whose disks are heated without limit is reported with figures; a dissipative run is not.
#include "state/energy_watch.h"

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
  EXPECT_EQ(simulation.energyText(), "");
  simulation.advanceTo(20000.0);
  EXPECT_GT(simulation.largestEnergy(), EnergyWatch::ALARM);
  const std::string text = simulation.energyText();
  EXPECT_EQ(text.rfind("implausibly large energy: at ", 0), 0u) << text;
  EXPECT_NE(text.find(" J at a height of "), std::string::npos) << text;
}

TEST(EnergyWatch, SaysNothingWhereCollisionsLoseWhatTheDriveGives)
{
  Simulation single(driven(0.9));
  single.advanceTo(20000.0);
  EXPECT_EQ(single.energyText(), "");
  EXPECT_LT(single.largestEnergy(), 50.0);

  SceneDefinition scene = test::mixture(60);
  scene.base.teeth = 5;
  Simulation mixture(scene);
  mixture.advanceTo(2.0);
  EXPECT_EQ(mixture.energyText(), "");
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
  const std::string first = simulation.energyText();
  ASSERT_NE(first, "");
  simulation.advanceTo(80.0);
  const std::string text = simulation.energyText();
  const std::string latest = "; largest so far: ";
  EXPECT_EQ(text.substr(0, text.find(latest)), first.substr(0, first.find(latest)));
  EXPECT_NE(text, first);

  Simulation resumed(scene, simulation.saveState());
  EXPECT_EQ(resumed.energyText(), text);
}

}  // namespace
}  // namespace ratchet_sieve
