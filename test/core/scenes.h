#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"

/// Scenes that several tests of the core use.
namespace ratchet_sieve::test
{

/// The disk of Fig. 3: r = 1 mm, m = 1 g, e = 0.6, mu = 0.1, beta = 0.4.
inline SpeciesDefinition smallDisk(int count)
{
  SpeciesDefinition species;
  species.name = "A";
  species.count = count;
  return species;
}

/// Fig. 3: single particles on a periodic base.
inline SceneDefinition singleParticles(int count)
{
  SceneDefinition scene;
  scene.species = {smallDisk(count)};
  scene.contact.pair_collisions = false;
  return scene;
}

/// Fig. 8: A (1 mm, 10 g) and B (2 mm, 1 g), 1:1; `count` of each.
inline SceneDefinition mixture(int count)
{
  SceneDefinition scene;
  scene.species = {smallDisk(count), smallDisk(count)};
  scene.species[0].mass = 0.010;
  scene.species[1].name = "B";
  scene.species[1].radius = 0.002;
  return scene;
}

/// Fig. 9: A (1 mm, 10 g) and B (5 mm, 1 g) on a = 0.1, open ends.
inline SceneDefinition openMixture(int count)
{
  SceneDefinition scene = mixture(count);
  scene.base.asymmetry = 0.1;
  scene.species[1].radius = 0.005;
  scene.boundary = Boundary::OPEN;
  return scene;
}

/// Short, open, with an even feed: thousands of disks come, leave, and are compacted away.
inline SceneDefinition fedSieve(bool pairs)
{
  SceneDefinition scene = mixture(5);
  scene.base.teeth = 3;
  scene.base.inclination = 0.3;
  scene.boundary = Boundary::OPEN;
  scene.feed.rate = 400.0;
  scene.feed.even = true;
  scene.settle = 1.0;
  scene.contact.pair_collisions = pairs;
  return scene;
}

/// Disks of Fig. 3's, of their density, with a radius `ratio` times as large.
inline SpeciesDefinition disksOfSize(double ratio, int count)
{
  SpeciesDefinition species = smallDisk(count);
  species.name = "of " + std::to_string(ratio);
  species.radius *= ratio;
  species.mass *= ratio * ratio;
  return species;
}

/// So many equal disks and one that is `ratio` times as large.
inline SceneDefinition oneLarge(int small, double ratio)
{
  SceneDefinition scene;
  scene.species = {disksOfSize(1.0, small), disksOfSize(ratio, 1)};
  scene.species[1].name = "large";
  return scene;
}

/// About `count` disks whose radii are lognormal around Fig. 3's, in classes a fifth of `sigma` wide.
inline SceneDefinition lognormalSizes(int count, double sigma)
{
  SceneDefinition scene;
  scene.species.clear();
  constexpr double STEP = 0.2;
  for (int k = -17; k <= 17; ++k)
  {
    const double z = STEP * k;
    const double share = STEP * std::exp(-0.5 * z * z) / std::sqrt(2.0 * 3.14159265358979323846);
    if (const auto disks = static_cast<int>(std::lround(count * share)); disks > 0)
      scene.species.push_back(disksOfSize(std::exp(sigma * z), disks));
  }
  return scene;
}

/// With disks of many sizes: the first species lognormal, others by a table of masses, each as wide as fits.
inline SceneDefinition withSizes(SceneDefinition scene)
{
  for (SpeciesDefinition& species : scene.species)
  {
    const double r = species.radius;
    species.size = {SizeDistribution::TABLE, 0.0, 2.0, {0.5 * r, r, 1.5 * r}, {0.2, 1.0, 2.0},
                    SizeShare::MASS};
  }
  scene.species[0].size = {SizeDistribution::LOGNORMAL, 0.3, 3.0, {}, {}, SizeShare::NUMBER};
  return scene;
}

inline SceneDefinition onProfile(SceneDefinition scene, const std::vector<OutlineCorner>& profile)
{
  scene.base.profile = profile;
  return scene;
}

/// @param step [s]
inline SceneDefinition bySteps(SceneDefinition scene, double step)
{
  scene.accuracy.method = Method::STEPS;
  scene.accuracy.step = step;
  return scene;
}

inline SceneDefinition withoutPairs(SceneDefinition scene)
{
  scene.contact.pair_collisions = false;
  return scene;
}

/// With all parts that a drive can have, at different phases.
inline SceneDefinition onAnOrbit(SceneDefinition scene)
{
  const double amplitude = 0.002;
  scene.base.horizontal_amplitude = 0.7 * amplitude;
  scene.base.horizontal_phase = 0.4;
  scene.base.harmonics = {{2, 0.15 * amplitude, 1.1, -0.1 * amplitude, 2.0},
                          {3, 0.0, 0.0, 0.05 * amplitude, 5.0}};
  return scene;
}

/// Fig. 3, and variants of it in each property that the SIMD code distinguishes.
inline std::vector<SceneDefinition> variantsForSimd()
{
  std::vector<SceneDefinition> scenes(8, singleParticles(150));
  scenes[1] = mixture(90);
  scenes[1].contact.pair_collisions = false;
  scenes[1].species[1].radius = 0.012;
  scenes[1].base.inclination = 0.2;
  scenes[1].base.teeth = 3;
  scenes[2].base.asymmetry = 0.0;
  scenes[2].base.inclination = -0.1;
  scenes[2].contact.restitution_speed = 0.4;
  scenes[3].base.tooth_height = 0.0;
  scenes[3].contact.restitution_speed = 2.0;
  scenes[3].contact.restitution_exponent = 0.3;
  scenes[4].base.tooth_width = 0.0008;
  scenes[4].base.tooth_height = 0.0004;
  scenes[4].base.teeth = 400;
  scenes[5].base.asymmetry = 1.0;
  scenes[5].gravity = 0.0;
  scenes[5].pour.speed = 1.0;
  scenes[5].contact.min_rebound_speed = 0.2;
  scenes[6] = withSizes(mixture(90));
  scenes[6].contact.pair_collisions = false;
  // Disks that come to rest again and again.
  scenes[7].species[0].count = 10;
  scenes[7].base.amplitude = 2e-5;
  scenes[7].contact.min_rebound_speed = 0.0;
  scenes[7].contact.collapse_events = 1000;
  scenes[7].contact.on_collapse = CollapseAction::REBOUND;
  return scenes;
}

}  // namespace ratchet_sieve::test
