#include "ratchet_sieve/core/layer.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "ratchet_sieve/core/count_text.h"
#include "ratchet_sieve/core/sizes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double PI = 3.14159265358979323846;

/// Packing fraction of a heap of disks: about random close packing in two dimensions.
constexpr double HEAP_PACKING = 0.82;

/// Upper bound of the memory per disk in a large run, including neighbours, events and sums [bytes].
constexpr double MEMORY_PER_DISK = 500.0;

/// Height of a heap of disks with this total area [m].
double heapHeight(const SceneDefinition& scene, double area)
{
  return scene.contact.pair_collisions ? area / (HEAP_PACKING * scene.base.width()) : 0.0;
}

double areaOf(const SpeciesDefinition& species)
{
  return PI * Sizes(species).meanSquare();
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
  return scene.boundary == Boundary::OPEN && scene.feed.rate <= 0.0;
}

double largestDiameter(const SceneDefinition& scene)
{
  double largest = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    largest = std::max(largest, 2.0 * Sizes(species).largest());
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
  out << countText(disksAtStart(scene), "disk") << ", ";
  if (scene.contact.pair_collisions)
    out << "at rest a layer of about " << settledLayer(scene) << " m, ";
  out << "about " << std::lround(std::max(1.0, 1e-6 * MEMORY_PER_DISK * disks)) << " MB of memory";
  return out.str();
}

}  // namespace ratchet_sieve
