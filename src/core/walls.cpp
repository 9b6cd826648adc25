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

/// Of g, the acceleration of the moving end, omega^2 W: up to here no disk went over a wall in any run of
/// docs/stability.md; from 0.37 on some did.
constexpr double CALM_ACCELERATION = 0.25;

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
