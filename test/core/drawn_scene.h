#pragma once

#include <algorithm>
#include <cmath>

#include <rapidcheck.h>

#include "profiles.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/results.h"
#include "scenes.h"

/// Scenes drawn by chance.
namespace ratchet_sieve::test
{

/// Log-uniform between low and high.
inline double drawnMagnitude(double low, double high)
{
  const double share = *rc::gen::inRange(0, 1001) * 1e-3;
  return low * std::pow(high / low, share);
}

inline ContactCoefficients drawnCoefficients()
{
  return {*rc::gen::element(0.0, 0.3, 0.6, 0.95, 1.0), *rc::gen::element(0.0, 0.1, 1.0, 1000.0),
          *rc::gen::element(-1.0, 0.0, 0.4, 1.0)};
}

/// Of any distribution, as wide as 1:50, with no disk wider than `largest` [m].
inline SizeDefinition drawnSizes(double radius, double largest)
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

inline Stretch drawnStretch(double width)
{
  const double from = *rc::gen::element(0.0, 0.0, 0.3, 0.9) * width;
  return *rc::gen::arbitrary<bool>() ? Stretch{from, from + *rc::gen::element(0.0, 0.05) * width}
                                     : Stretch{from};
}

/// Any scene that the scene layer accepts, small enough to run fast.
inline SceneDefinition drawnScene()
{
  SceneDefinition scene = mixture(*rc::gen::inRange(0, 20));
  scene.base.teeth = *rc::gen::inRange(1, 8);
  scene.base.tooth_width = *rc::gen::element(0.002, 0.02, 0.02);
  scene.base.asymmetry = *rc::gen::element(0.0, 0.1, 0.3, 0.5, 1.0);
  scene.base.tooth_height = *rc::gen::element(0.0, 0.001, 0.006, 0.04);
  if (*rc::gen::inRange(0, 3) == 0)
    scene.base.profile =
        drawnProfile(scene.base.tooth_width, scene.base.tooth_height, *rc::gen::element(3, 10, 100));
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

}  // namespace ratchet_sieve::test
