#include "state/placement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "state/audit.h"
#include "state/pour.h"

namespace ratchet_sieve
{
namespace
{
/// The pour observer is called after this many disks: some hundred times a second.
constexpr std::size_t DISKS_PER_LOOK = 1024;

/// A disk's position at `time`, for the pour.
PlacedDisk placed(const SystemState& system, std::uint32_t slot, const FrameOfBase& base, double time)
{
  const Disk disk = flown(system.disk(slot), time, system.scene().gravity);
  const double s = base.positionInto(disk.position).x();
  return {s - system.shape().width() * system.widthsOutside(s), base.into(disk.position).y(),
          system.radius(slot)};
}

struct Poured
{
  PlacedDisk room;
  std::uint32_t species;
};

/// Finds room for a disk of each of these species; in the order along the base. The memory of the search, as
/// much as that of the disks, is freed before they are added.
std::vector<Poured> findRoom(const SystemState& system, const std::vector<std::uint32_t>& species,
                             const Stretch& stretch, double time, Random& random,
                             const PourObserver& observer)
{
  const SceneDefinition& scene = system.scene();
  const FrameOfBase base = system.motion().at(time);
  BaseDefinition shape = scene.base;
  shape.amplitude = system.motion().displacementBound().norm();
  Pour pour(shape, scene.boundary, stretch, scene.pour.drop_height, system.largestDiameter(),
            scene.contact.pair_collisions);
  for (std::uint32_t slot = 0; slot < system.disks().size(); ++slot)
    if (system.active(slot))
      pour.occupy(placed(system, slot, base, time));
  std::vector<Poured> poured;
  poured.reserve(species.size());
  for (const std::uint32_t kind : species)
  {
    const double radius = system.sizes(kind).draw([&random] { return random.uniform(); });
    poured.push_back({pour.place(radius, random), kind});
    if (observer && poured.size() % DISKS_PER_LOOK == 0)
      observer(poured.size(), species.size());
  }
  // Numbered along the base, so that neighbours are near each other in memory.
  std::stable_sort(poured.begin(), poured.end(),
                   [](const Poured& a, const Poured& b) { return a.room.s < b.room.s; });
  return poured;
}
}  // namespace

void pourDisks(SystemState& system, const std::vector<std::uint32_t>& species, const Stretch& stretch,
               double time, Random& random, const PourObserver& observer)
{
  const SceneDefinition& scene = system.scene();
  const FrameOfBase base = system.motion().at(time);
  const std::vector<Poured> poured = findRoom(system, species, stretch, time, random, observer);
  system.reserve(system.disks().size() + poured.size());
  for (const auto& [room, kind] : poured)
  {
    const Eigen::Vector2d place = base.outOf({room.s + base.into(base.displacement).x(), room.n});
    Disk disk;
    disk.position.x() = place.x();
    disk.position.y() = place.y();
    disk.velocity.y() = -scene.pour.speed;
    disk.time = time;
    disk.species = kind;
    disk.radius = room.radius;
    system.add(disk, grainOf(scene.species[kind], room.radius));
  }
}

void placeInitialDisks(SystemState& system, double time)
{
  for (const InitialDisk& initial : system.scene().initial)
  {
    Disk disk;
    disk.position = {initial.x, initial.y};
    disk.velocity = {initial.vx, initial.vy};
    disk.spin = initial.spin;
    disk.time = time;
    disk.species = static_cast<std::uint32_t>(initial.species);
    const SpeciesDefinition& species = system.scene().species[initial.species];
    disk.radius = species.radius;
    system.add(disk, grainOf(species, disk.radius));
  }
  refuseBadStart(system, time);
}

}  // namespace ratchet_sieve
