#include <cmath>
#include <utility>

#include "draws.h"
#include "model/base_motion.h"
#include "scene_spelling.h"
#include "scene_spoilers.h"

namespace ratchet_sieve
{
namespace
{

/// Moves a disk along the base and away from it.
void move(const SceneDefinition& scene, InitialDisk& disk, double ds, double dn)
{
  const Eigen::Vector2d way = BaseMotion(scene.base).at(0.0).outOf({ds, dn});
  disk.x += way.x();
  disk.y += way.y();
}

/// A disk's place in the frame of the base: along it, and over the line of the teeth's ends.
std::pair<double, double> onBase(const SceneDefinition& scene, const InitialDisk& disk)
{
  const BasePoint point = BaseMotion(scene.base).at(0.0).see({disk.x, disk.y}, Eigen::Vector2d::Zero());
  return {point.s(), point.n()};
}

/// A place beyond an end of the base that is still a legal number.
double drawnOutside(const SceneDefinition& scene)
{
  constexpr double FARTHEST = 4e8;  ///< [m]
  const double width = scene.base.width();
  const double beyond = std::min(FARTHEST, width * drawnMagnitude(1e-6, 1.0));
  return width > FARTHEST || drawnChance(50) ? -beyond : width + beyond;
}

std::string nameOf(std::size_t disk)
{
  return "initial." + std::to_string(disk);
}

}  // namespace

MisplacedScene drawnMisplacedScene(Misplaced how)
{
  std::vector<std::string> words;
  SceneDefinition scene = drawnPlacedScene().definition;
  const auto at = drawnIndex<std::size_t>(0, scene.initial.size());
  InitialDisk& disk = scene.initial[at];
  const double radius = scene.species[disk.species].radius;
  switch (how)
  {
    case Misplaced::OVERLAPPING:
    {
      // Only the new one overlaps any other.
      scene.contact.pair_collisions = true;
      InitialDisk other = disk;
      move(scene, other, 0.0, radius * drawnMagnitude(1e-3, 1.9));
      scene.initial.push_back(other);
      words = {nameOf(scene.initial.size() - 1), " overlap by "};
      break;
    }
    case Misplaced::BURIED:
      move(scene, disk, 0.0,
           -onBase(scene, disk).second - scene.base.depth() - radius * drawnMagnitude(1e-3, 1e1));
      words = {nameOf(at) + " overlaps the base"};
      break;
    case Misplaced::OUTSIDE:
      // Walls might be in the way of the other disks.
      if (scene.boundary == Boundary::PERIODIC)
        scene.boundary = Boundary::OPEN;
      move(scene, disk, drawnOutside(scene) - onBase(scene, disk).first, 0.0);
      words = {nameOf(at) + " is outside"};
      break;
  }
  return {{scene, spelled(scene, std::nullopt)}, words};
}

}  // namespace ratchet_sieve
