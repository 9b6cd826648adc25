#include <cmath>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// A mixture of 200 disks over a base at rest that loses no energy.
SceneDefinition lossless(double friction, double tangential_restitution)
{
  SceneDefinition scene = test::mixture(100);
  scene.base.amplitude = 0.0;
  scene.contact.min_rebound_speed = 0.0;
  for (auto& species : scene.species)
    species.contact = {1.0, friction, tangential_restitution};
  scene.pour.drop_height = 0.05;
  return scene;
}

double relativeDrift(const SceneDefinition& scene, double duration, std::uint64_t at_least)
{
  Simulation simulation(scene);
  const double start = simulation.energy();
  simulation.advanceTo(duration);
  EXPECT_GE(simulation.collisions().total(), at_least);
  return std::abs(simulation.energy() / start - 1.0);
}

TEST(Conservation, ElasticDisksKeepTheirEnergy)
{
  EXPECT_LT(relativeDrift(lossless(0.0, 0.0), 250.0, 1000000), 1e-10);
}

TEST(Conservation, ElasticDisksOfManySizesKeepTheirEnergy)
{
  EXPECT_LT(relativeDrift(test::withSizes(lossless(0.0, 0.0)), 100.0, 300000), 1e-10);
  EXPECT_LT(relativeDrift(test::withSizes(lossless(1e9, 1.0)), 100.0, 300000), 1e-10);
}

TEST(Conservation, PerfectlyRoughDisksKeepTheirEnergyWithTheirSpins)
{
  EXPECT_LT(relativeDrift(lossless(1e9, 1.0), 250.0, 1000000), 1e-10);
}

TEST(Conservation, TheBaseCarriesTheWeight)
{
  // Stationary: the vertical impulse from the base is N m g T but for the change of momentum
  // between the two ends, which is below N m times the typical speed of 0.3 m/s.
  SceneDefinition scene = test::mixture(131);
  scene.base.teeth = 10;
  scene.settle = 2.0;
  Simulation simulation(scene);
  simulation.advanceTo(12.0);
  const double weight = 131 * (0.010 + 0.001) * 9.81;
  EXPECT_NEAR(simulation.baseImpulse().y() / (weight * 10.0), 1.0, 0.01);
}

TEST(Conservation, MirroredMachineRunsTheOtherWay)
{
  SceneDefinition scene = test::singleParticles(300);
  scene.base.inclination = 0.05;
  scene.settle = 1.0;
  SceneDefinition mirrored = scene;
  mirrored.base.asymmetry = 1.0 - scene.base.asymmetry;
  mirrored.base.inclination = -scene.base.inclination;
  Simulation one(scene), other(mirrored);
  one.advanceTo(20.0);
  other.advanceTo(20.0);
  const auto a = one.means()[0];
  const auto b = other.means()[0];
  EXPECT_NEAR(*a.mean_vx + *b.mean_vx, 0.0, 4.0 * std::hypot(*a.mean_vx_stderr, *b.mean_vx_stderr));
  EXPECT_GT(*a.mean_vx, 10.0 * *a.mean_vx_stderr);
}

}  // namespace
}  // namespace ratchet_sieve
