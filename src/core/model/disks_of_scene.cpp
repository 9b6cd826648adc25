#include "ratchet_sieve/core/disks_of_scene.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/sizes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double PI = 3.14159265358979323846;

/// Packing fraction of a heap of disks: about random close packing in two dimensions.
constexpr double HEAP_PACKING = 0.82;

/// Height of a heap of disks with this total area [m].
double heapHeight(const SceneDefinition& scene, double area)
{
  return scene.contact.pair_collisions ? area / (HEAP_PACKING * scene.base.width()) : 0.0;
}

double areaOf(const SpeciesDefinition& species)
{
  return PI * Sizes(species).meanSquare();
}

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

std::size_t disksAtStart(const SceneDefinition& scene)
{
  std::size_t disks = scene.initial.size();
  for (const SpeciesDefinition& species : scene.species)
    disks += static_cast<std::size_t>(species.count);
  return disks;
}

bool empties(const SceneDefinition& scene)
{
  return scene.boundary == Boundary::OPEN && !scene.feed.any();
}

double largestDiameter(const SceneDefinition& scene)
{
  double largest = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    largest = std::max(largest, 2.0 * Sizes(species).largest());
  for (const FedDisk& disk : scene.feed.disks)
    largest = std::max(largest, 2.0 * disk.radius);
  return largest;
}

double pouredWidth(const SceneDefinition& scene)
{
  const double width = scene.base.width();
  return std::min(width, scene.pour.stretch.length(width) + largestDiameter(scene));
}

double smallestRadius(const SceneDefinition& scene)
{
  double smallest = Sizes(scene.species.front()).smallest();
  for (const SpeciesDefinition& species : scene.species)
    smallest = std::min(smallest, Sizes(species).smallest());
  for (const FedDisk& disk : scene.feed.disks)
    smallest = std::min(smallest, disk.radius);
  return smallest;
}

double settledLayer(const SceneDefinition& scene)
{
  double area = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    area += species.count * areaOf(species);
  for (const InitialDisk& disk : scene.initial)
    area += PI * scene.species[disk.species].radius * scene.species[disk.species].radius;
  return heapHeight(scene, area);
}

double feedRate(const SceneDefinition& scene)
{
  const std::vector<FedDisk>& disks = scene.feed.disks;
  return disks.empty() ? scene.feed.rate
                       : static_cast<double>(disks.size()) / std::max(disks.back().time, timeScale(scene));
}

double feedGrowth(const SceneDefinition& scene)
{
  double shares = 0.0;
  double area = 0.0;
  for (const SpeciesDefinition& species : scene.species)
  {
    shares += species.share;
    area += species.share * areaOf(species);
  }
  if (const std::vector<FedDisk>& disks = scene.feed.disks; !disks.empty())
  {
    shares = static_cast<double>(disks.size());
    area =
        std::accumulate(disks.begin(), disks.end(), 0.0,
                        [](double sum, const FedDisk& disk) { return sum + PI * disk.radius * disk.radius; });
  }
  return shares > 0.0 ? heapHeight(scene, feedRate(scene) * area / shares) : 0.0;
}

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
