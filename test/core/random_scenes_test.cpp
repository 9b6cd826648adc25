#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "profiles.h"
#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/core/sizes.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{

/// Log-uniform between low and high.
double drawnMagnitude(double low, double high)
{
  const double share = *rc::gen::inRange(0, 1001) * 1e-3;
  return low * std::pow(high / low, share);
}

ContactCoefficients drawnCoefficients()
{
  return {*rc::gen::element(0.0, 0.3, 0.6, 0.95, 1.0), *rc::gen::element(0.0, 0.1, 1.0, 1000.0),
          *rc::gen::element(-1.0, 0.0, 0.4, 1.0)};
}

/// Of any distribution, as wide as 1:50, with no disk wider than `largest` [m].
SizeDefinition drawnSizes(double radius, double largest)
{
  SizeDefinition size;
  size.distribution = *rc::gen::element(SizeDistribution::UNIFORM, SizeDistribution::NORMAL,
                                        SizeDistribution::LOGNORMAL, SizeDistribution::TABLE);
  size.mass_exponent = *rc::gen::element(0.0, 1.0, 2.0, 3.0, 3.5);
  size.by = *rc::gen::element(SizeShare::NUMBER, SizeShare::MASS);
  const double factor = largest / radius;
  switch (size.distribution)
  {
    case SizeDistribution::UNIFORM:
      size.spread = std::min(0.9, factor - 1.0);
      break;
    case SizeDistribution::NORMAL:
      size.spread = std::min(0.3, (factor - 1.0) / 3.0);
      break;
    case SizeDistribution::LOGNORMAL:
      size.spread = std::min(0.65, std::log(factor) / 3.0);
      break;
    case SizeDistribution::TABLE:
      size.radii = {radius / 7.0, radius, std::max(1.001 * radius, std::min(7.0 * radius, largest))};
      size.weights = {*rc::gen::element(0.0, 1.0), 1.0, *rc::gen::element(0.0, 1.0, 0.01)};
  }
  return size;
}

Stretch drawnStretch(double width)
{
  const double from = *rc::gen::element(0.0, 0.0, 0.3, 0.9) * width;
  return *rc::gen::arbitrary<bool>() ? Stretch{from, from + *rc::gen::element(0.0, 0.05) * width}
                                     : Stretch{from};
}

/// Any scene that the scene layer accepts, small enough to run fast.
SceneDefinition drawnScene()
{
  SceneDefinition scene = test::mixture(*rc::gen::inRange(0, 20));
  scene.base.teeth = *rc::gen::inRange(1, 8);
  scene.base.tooth_width = *rc::gen::element(0.002, 0.02, 0.02);
  scene.base.asymmetry = *rc::gen::element(0.0, 0.1, 0.3, 0.5, 1.0);
  scene.base.tooth_height = *rc::gen::element(0.0, 0.001, 0.006, 0.04);
  if (*rc::gen::inRange(0, 3) == 0)
    scene.base.profile =
        test::drawnProfile(scene.base.tooth_width, scene.base.tooth_height, *rc::gen::element(3, 10, 100));
  scene.base.inclination = *rc::gen::element(0.0, 0.2, -0.2, 1.2);
  scene.base.drive_frame = *rc::gen::element(DriveFrame::WORLD, DriveFrame::BASE);
  scene.base.amplitude = *rc::gen::element(0.0, 0.0005, 0.002, 0.02);
  scene.base.frequency = *rc::gen::element(0.0, 5.0, 23.0, 120.0);
  if (*rc::gen::inRange(0, 3) == 0)
  {
    scene.base.horizontal_amplitude = *rc::gen::element(-0.002, 0.0005, 0.01);
    scene.base.horizontal_phase = *rc::gen::element(0.0, 1.5, 4.0);
    if (*rc::gen::arbitrary<bool>())
      scene.base.harmonics = {{*rc::gen::inRange(2, 6), 0.0003, 1.0, *rc::gen::element(0.0, -0.0005), 2.0}};
  }
  scene.boundary = *rc::gen::element(Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED);
  scene.base.wall_height = *rc::gen::element(0.0, 0.0, 0.05, 0.3, 2.0) * scene.base.width();
  scene.gravity = *rc::gen::element(0.0, 1.6, 9.81, 9.81);
  scene.contact.pair_collisions = *rc::gen::element(true, true, false);
  scene.contact.min_rebound_speed = *rc::gen::element(0.02, 0.05, 0.5);
  scene.contact.contact_duration = *rc::gen::element(0.0, 0.0, 1e-4);
  scene.feed.rate = *rc::gen::element(0.0, 0.0, 40.0);
  scene.pour.speed = *rc::gen::element(0.0, 1.0);
  scene.pour.stretch = drawnStretch(scene.base.width());
  scene.feed.stretch = drawnStretch(scene.base.width());
  scene.observe = *rc::gen::element(std::vector<std::string>(), observableNames());
  scene.seed = *rc::gen::arbitrary<std::uint64_t>();
  const double largest = 0.45 * scene.base.width();
  for (SpeciesDefinition& species : scene.species)
  {
    species.radius = std::min(largest, drawnMagnitude(5e-3, 1.0) * scene.base.tooth_width);
    species.mass = drawnMagnitude(1e-4, 1e-1);
    species.contact = drawnCoefficients();
    species.inertia_factor = *rc::gen::element(0.01, 0.4, 0.5, 1.0);
    if (*rc::gen::arbitrary<bool>())
      species.size = drawnSizes(species.radius, 1.01 * largest);
  }
  return scene;
}

void commandSomething(Simulation& simulation)
{
  switch (*rc::gen::inRange(0, 6))
  {
    case 0:
      return simulation.command(Quantity::INCLINATION, *rc::gen::element(0.0, 0.15, -0.3));
    case 1:
      return simulation.command(Quantity::FREQUENCY, *rc::gen::element(0.0, 10.0, 40.0));
    case 2:
      return simulation.command(Quantity::AMPLITUDE, *rc::gen::element(0.0, 0.001, 0.004));
    case 3:
      return simulation.pour(*rc::gen::inRange(0, 2), 3);
    default:
      return;
  }
}

void checkState(Simulation& simulation)
{
  const std::size_t behind = simulation.auditOverlaps();
  if (!simulation.plan().steps)
  {
    RC_ASSERT(behind == 0u);
    const double smallest = smallestRadius(simulation.scene());
    // The resolution of a double at positions of a few metres and speeds of about ten m/s.
    const double rounding = 1e-13;
    RC_ASSERT(simulation.maxOverlap() <= 1e-9 * smallest + rounding);
  }
  std::uint64_t on_base = 0;
  for (const SpeciesBins& bins : simulation.bins())
    on_base += bins.on_base;
  RC_ASSERT(on_base == simulation.activeDisks());
  for (const DiskState& disk : simulation.disks())
    for (const double value : {disk.x, disk.y, disk.vx, disk.vy, disk.angle, disk.spin, disk.displacement})
      RC_ASSERT(std::isfinite(value));
  RC_ASSERT(std::isfinite(simulation.energy()));
  RC_ASSERT(simulation.observed().size() == simulation.scene().observe.size());
}

void expectThatNothingGetsLost(Method method)
{
  int runs = 0;
  int stalls = 0;
  EXPECT_TRUE(rc::check(
      [&]
      {
        ++runs;
        SceneDefinition scene = drawnScene();
        scene.accuracy.method = method;
        scene.accuracy.step = *rc::gen::element(1e-4, 0.001, 0.02);
        Simulation simulation(scene);
        simulation.setSlewRates({*rc::gen::element(0.05, 0.5), 20.0, 0.01});
        try
        {
          for (int k = 1; k <= 20; ++k)
          {
            simulation.advanceTo(0.05 * k);
            checkState(simulation);
            commandSomething(simulation);
          }
        }
        catch (const StallError&)
        {
          // A jam, for example a disk wedged between two faces, is reported.
          ++stalls;
        }
      }));
  EXPECT_LE(stalls, 3 + runs / 50) << "of " << runs << " runs";
}

TEST(RandomScenes, NothingLeaksOverlapsOrGetsLost)
{
  expectThatNothingGetsLost(Method::EVENTS);
}

TEST(RandomScenes, NothingGetsLostBySteps)
{
  expectThatNothingGetsLost(Method::STEPS);
}

}  // namespace
}  // namespace ratchet_sieve
