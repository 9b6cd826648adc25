#include "ratchet_sieve/core/walls.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// With 5 widths, 8 of 120 disks go over a wall that is the floor of a base at 1.5 rad, shaken with 4 g; with
/// 10 none.
constexpr double WALL_WIDTHS = 10.0;

/// Poured disks lie so loosely that each takes up this many squares of its diameter.
constexpr double SQUARES_PER_DISK = 2.0;

/// Of the far end towards the foot that the base turns about, omega^2 W, in g: up to 0.16 no disk went over a
/// wall in the runs of docs/stability.md, at 0.18 one of 160 did, at 0.5 most.
constexpr double CALM_ACCELERATION = 0.15;

/// About how high the poured disks lie; without the drive's amplitude, which a setpoint may change [m].
double topOfPour(const SceneDefinition& scene)
{
  double squares = 0.0;
  double largest = 0.0;
  for (const SpeciesDefinition& species : scene.species)
  {
    const double diameter = 2.0 * species.radius;
    squares += species.count * diameter * diameter;
    largest = std::max(largest, diameter);
  }
  return scene.base.tooth_height + scene.pour.drop_height + largest +
         SQUARES_PER_DISK * squares / scene.base.width();
}

}  // namespace

double wallHeight(const SceneDefinition& scene)
{
  if (scene.base.wall_height > 0.0)
    return scene.base.wall_height;
  return topOfPour(scene) + WALL_WIDTHS * scene.base.width();
}

double calmTurnRate(const SceneDefinition& scene)
{
  return std::sqrt(CALM_ACCELERATION * scene.gravity / scene.base.width());
}

}  // namespace ratchet_sieve
