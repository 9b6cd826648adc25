#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/drawn_scene.h"
#include "model/base_motion.h"
#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/resolution.h"
#include "schema.h"

/// Scenes drawn by chance, as large and as small as the scene layer accepts, that run fast.
namespace ratchet_sieve
{

inline bool drawnChance(int percent)
{
  return *rc::gen::inRange(0, 100) >= 100 - percent;
}

/// The same machine in other units: what happens in it does not change.
inline void rescale(SceneDefinition& scene, double length, double time, double mass)
{
  const std::map<std::string, double> factors = {{"m", length},
                                                 {"s", time},
                                                 {"kg", mass},
                                                 {"m/s", length / time},
                                                 {"m/s^2", length / time / time},
                                                 {"1/s", 1.0 / time},
                                                 {"rad/s", 1.0 / time},
                                                 {"Hz", 1.0 / time}};
  forEachNumber(scene,
                [&](const std::string&, const char* unit, double& number)
                {
                  if (const auto factor = factors.find(unit); factor != factors.end())
                    number *= factor->second;
                });
}

/// Nothing moves the disks but what they have, and no contact makes energy. What would come to rest in
/// endless contacts is kept from it: by restitution, or by contacts that lose nothing where they follow each
/// other.
inline void bringToRest(SceneDefinition& scene)
{
  scene.base.frequency = 0.0;
  scene.feed.rate = 0.0;
  scene.contact.min_rebound_speed = 0.0;
  scene.contact.contact_duration = *rc::gen::element(0.0, 0.01, 0.1) * timeScale(scene);
  const double least = scene.contact.contact_duration > 0.0 ? 0.5 : 1.0;
  for (SpeciesDefinition& species : scene.species)
    species.contact.restitution = std::max(least, species.contact.restitution);
}

/// In the frame of the base, one above the other, so that none overlaps another or the base.
inline void placeDisks(SceneDefinition& scene)
{
  const double width = scene.base.width();
  const FrameOfBase frame = BaseMotion(scene.base).at(0.0);
  double n = scene.base.highest();
  for (int count = *rc::gen::inRange(1, 7); count > 0; --count)
  {
    InitialDisk disk;
    disk.species = *rc::gen::inRange<std::size_t>(0, scene.species.size());
    const double radius = scene.species[disk.species].radius;
    n += radius * *rc::gen::element(1.001, 1.5, 8.0);
    const Eigen::Vector2d place = frame.positionOutOf({drawn(1.01 * radius, width - 1.01 * radius), n});
    n += radius;
    disk.x = place.x();
    disk.y = place.y();
    disk.vx = drawn(-1.0, 1.0);
    disk.vy = drawn(-1.0, 1.0);
    disk.spin = drawn(-1.0, 1.0) / radius;
    scene.initial.push_back(disk);
  }
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;
}

/// By steps of any length that is legal, as long as there are not too many.
inline void drawMethod(SceneDefinition& scene)
{
  constexpr double SHORTEST = 1e-7;  ///< [s]
  constexpr double LONGEST = 0.1;    ///< [s]
  const double step = std::clamp(timeScale(scene) * test::drawnMagnitude(1e-3, 1.0), SHORTEST, LONGEST);
  if (!drawnChance(15) || scene.duration > 1e3 * step)
    return;
  scene.accuracy.method = Method::STEPS;
  scene.accuracy.step = step;
}

/// Units in which no number of the scene is beyond what is legal. @param smallest length in it [m]
inline void drawUnits(SceneDefinition& scene, double smallest)
{
  constexpr double SMALLEST = 1e-9;  ///< length [m]
  constexpr double LARGEST = 1e3;    ///< length [m]
  double largest = 0.0;
  forEachNumber(scene,
                [&](const std::string&, const char* unit, double& number)
                {
                  if (std::string(unit) == "m" && std::isfinite(number))
                    largest = std::max(largest, std::abs(number));
                });
  const double length = test::drawnMagnitude(1.001 * SMALLEST / smallest, 0.999 * LARGEST / largest);
  constexpr double SHORTEST = 1.3e-4;  ///< unit of time: frequencies are at most 1e6 Hz
  const double time = std::max(SHORTEST, std::sqrt(length) * test::drawnMagnitude(0.05, 100.0));
  rescale(scene, length, time, test::drawnMagnitude(1e-13, 1e6));
  scene.accuracy.step = AccuracyDefinition().step;
}

inline SceneDefinition drawnLegalScene()
{
  SceneDefinition scene = test::drawnScene();
  double smallest = smallestRadius(scene);
  if (!scene.base.profile.empty())
  {
    smallest *= 1e-3;
    scene.base.profile = test::drawnProfile(scene.base.tooth_width, scene.base.tooth_height, 12, smallest);
  }
  scene.base.phase = drawn(-1e6, 1e6);
  scene.base.asymmetry = drawn(0.0, 1.0);
  scene.species[0].name = *rc::gen::element<std::string>("A", "b-2", "true", "1e3");
  scene.species[0].share = *rc::gen::element(0.0, 1.0, 1e9);
  scene.contact.restitution_speed = *rc::gen::element(0.0, 0.0, 0.5);
  scene.contact.collapse_events = 2e4;  // a collapse is an end, and each run is to be short
  scene.height_profile.phases = *rc::gen::inRange(1, 65);
  if (drawnChance(30))
    scene.pairs = {{1, 0, test::drawnCoefficients()}};
  if (drawnChance(20))
    bringToRest(scene);
  if (drawnChance(25))
    placeDisks(scene);
  scene.duration = drawn(0.0, 0.3);
  scene.settle = *rc::gen::element(0.0, 0.0, 0.5, 1.0) * scene.duration;
  drawUnits(scene, smallest);
  drawMethod(scene);
  return scene;
}

}  // namespace ratchet_sieve
