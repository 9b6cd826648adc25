#include "ratchet_sieve/core/walls.h"

#include <cmath>

#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/sizes.h"

namespace ratchet_sieve
{
namespace
{
/// With 5 widths, 8 of 120 disks go over a wall that acts as the floor of a base at 1.5 rad, shaken with 4 g;
/// with 10 widths none.
constexpr double WALL_WIDTHS = 10.0;

/// Poured disks are loosely packed: each occupies this many squares of its diameter.
constexpr double SQUARES_PER_DISK = 2.0;

/// Acceleration of the far end of the turning base towards its centre of rotation, omega^2 W, in g. In the
/// runs of docs/stability.md no disk went over a wall up to 0.16, one of 160 did at 0.18, and most did at
/// 0.5.
constexpr double CALM_ACCELERATION = 0.15;

/// Approximate top of the poured disks, without the drive's amplitude, which a setpoint may change [m].
double topOfPour(const SceneDefinition& scene)
{
  double squares = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    squares += species.count * (4.0 * Sizes(species).meanSquare());
  return scene.base.highest() + scene.pour.drop_height + largestDiameter(scene) +
         SQUARES_PER_DISK * squares / pouredWidth(scene);
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
