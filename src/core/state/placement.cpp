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
  const double width = system.sawtooth().width();
  double s = base.into(Eigen::Vector2d(disk.position.x(), disk.position.y()) - base.displacement).x();
  if (system.scene().boundary == Boundary::PERIODIC)
    s -= width * wholeWidths(s, 1.0 / width);
  return {s, base.into({disk.position.x(), disk.position.y()}).y(), system.radius(slot)};
}

}  // namespace

void pourDisks(Machine& system, const std::vector<std::uint32_t>& species, const Stretch& stretch,
               double time, Random& random, const PourObserver& observer)
{
  const SystemState& state = system.state();
  const SceneDefinition& scene = state.scene();
  const FrameOfBase base = state.motion().at(time);
  BaseDefinition shape = scene.base;
  shape.amplitude = state.motion().displacementBound().norm();
  Pour pour(shape, scene.boundary, stretch, scene.pour.drop_height, state.largestDiameter(),
            scene.contact.pair_collisions);
  for (std::uint32_t slot = 0; slot < state.disks().size(); ++slot)
    if (state.active(slot))
      pour.occupy(placed(state, slot, base, time));
  struct Poured
  {
    PlacedDisk room;
    std::uint32_t species;
  };
  std::vector<Poured> poured;
  poured.reserve(species.size());
  for (const std::uint32_t kind : species)
  {
    const double radius = state.sizes(kind).draw([&random] { return random.uniform(); });
    poured.push_back({pour.place(radius, random), kind});
    if (observer && poured.size() % DISKS_PER_LOOK == 0)
      observer(poured.size(), species.size());
  }
  // Numbered along the base, so that neighbours are near each other in memory.
  std::stable_sort(poured.begin(), poured.end(),
                   [](const Poured& a, const Poured& b) { return a.room.s < b.room.s; });
  system.reserve(state.disks().size() + poured.size());
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

void placeInitialDisks(Machine& system, double time)
{
  for (const InitialDisk& initial : system.state().scene().initial)
  {
    Disk disk;
    disk.position = {initial.x, initial.y};
    disk.velocity = {initial.vx, initial.vy};
    disk.spin = initial.spin;
    disk.time = time;
    disk.species = static_cast<std::uint32_t>(initial.species);
    const SpeciesDefinition& species = system.state().scene().species[initial.species];
    disk.radius = species.radius;
    system.add(disk, grainOf(species, disk.radius));
  }
  refuseBadStart(system.state(), time);
}

}  // namespace ratchet_sieve
