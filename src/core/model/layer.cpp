#include "ratchet_sieve/core/layer.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace ratchet_sieve
{
namespace
{
constexpr double PI = 3.14159265358979323846;

/// The share of the plane that disks fill in a random heap: about that of random close packing in two
/// dimensions.
constexpr double HEAP_PACKING = 0.82;

/// What a disk takes at the most in a run of many, neighbours, events and sums included [bytes].
constexpr double MEMORY_PER_DISK = 500.0;

/// The height of a heap of disks of this area, all together [m].
double heapHeight(const SceneDefinition& scene, double area)
{
  return scene.contact.pair_collisions ? area / (HEAP_PACKING * scene.base.width()) : 0.0;
}

double areaOf(const SpeciesDefinition& species)
{
  return PI * species.radius * species.radius;
}
}  // namespace

std::size_t disksAtStart(const SceneDefinition& scene)
{
  std::size_t disks = scene.initial.size();
  for (const SpeciesDefinition& species : scene.species)
    disks += static_cast<std::size_t>(species.count);
  return disks;
}

double settledLayer(const SceneDefinition& scene)
{
  double area = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    area += species.count * areaOf(species);
  for (const InitialDisk& disk : scene.initial)
    area += areaOf(scene.species[disk.species]);
  return heapHeight(scene, area);
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
  return shares > 0.0 ? heapHeight(scene, scene.feed.rate * area / shares) : 0.0;
}

std::string sizeText(const SceneDefinition& scene)
{
  const auto disks = static_cast<double>(disksAtStart(scene));
  std::ostringstream out;
  out.precision(3);
  out << disksAtStart(scene) << " disks, ";
  if (scene.contact.pair_collisions)
    out << "at rest a layer of about " << settledLayer(scene) << " m, ";
  out << "about " << std::lround(std::max(1.0, 1e-6 * MEMORY_PER_DISK * disks)) << " MB of memory";
  return out.str();
}

}  // namespace ratchet_sieve
