#include "state/placement.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "ratchet_sieve/geometry/pour.h"
#include "ratchet_sieve/geometry/size_levels.h"
#include "search/cell_grid.h"
#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// Touching disks are legal: an overlap below this fraction of the radius, or of the resolution at the disk's
/// position or of its flight, is rounding.
constexpr double TOUCHING = 1e-12;
constexpr double ROUNDING = 8.0 * std::numeric_limits<double>::epsilon();

/// Side of the audit's cells in units of the largest diameter. Fewer cells than in the engine are built
/// faster, and need less memory with a million disks.
constexpr double AUDIT_CELL = 2.0;

/// @param point the centre, in the frame of the base [m]
double toleratedOverlap(const Eigen::Vector2d& point, const Disk& disk)
{
  return TOUCHING * disk.radius + ROUNDING * (point.lpNorm<1>() + disk.position.lpNorm<1>());
}

/// The positions of all disks in the frame of the base, wrapped into [0, W) if it is periodic.
std::vector<Eigen::Vector2d> placesOnBase(const SystemState& system, double time)
{
  const FrameOfBase base = system.motion().at(time);
  const double width = system.shape().width();
  std::vector<Eigen::Vector2d> points;
  points.reserve(system.disks().size());
  for (const Disk& disk : system.disks())
  {
    const Eigen::Vector2d point = base.positionInto(positionAt(disk, time, system.scene().gravity));
    points.emplace_back(point.x() - width * system.widthsOutside(point.x()), point.y());
  }
  return points;
}

/// Distance of a disk from the base and the walls, < 0 for an overlap.
double gapToBase(const SystemState& system, const Eigen::Vector2d& point, double radius)
{
  const BaseShape& shape = system.shape();
  double gap = point.y() - shape.height();
  if (gap < radius)
    gap = shape.heightAbove(point.x(), point.y());
  return std::min(gap, shape.distanceToWalls(point.x(), point.y())) - radius;
}

using VisitPair = std::function<void(std::uint32_t, std::uint32_t, double overlap)>;

/// Visits every pair of disks near enough to overlap, once or more often.
void forEachNearPair(const SystemState& system, const std::vector<Eigen::Vector2d>& points,
                     const VisitPair& visit)
{
  const double width = system.shape().width();
  const bool periodic = system.shape().boundary() == Boundary::PERIODIC;
  double top = system.largestDiameter();
  const std::vector<std::uint32_t> active = system.slots(true);
  for (const std::uint32_t slot : active)
    top = std::max(top, points[slot].y());
  const SizeLevels levels = cheapestLevels(system.activeRadii(), system.largestDiameter());
  const CellShape shape(width, top, AUDIT_CELL * levels.diameters[0], points.size(), periodic);
  CellGrid grid(shape, levels, 0.0, points.size());
  for (const std::uint32_t slot : active)
    grid.add(slot, grid.cellAt(points[slot].x(), points[slot].y()), system.radius(slot));
  std::vector<std::uint32_t> list;
  for (const std::uint32_t slot : active)
    grid.visit(slot, CellEdge::NONE, list,
               [&](const std::uint32_t* slots, std::size_t count, int shift)
               {
                 for (const std::uint32_t* other = slots; other != slots + count; ++other)
                 {
                   // A large disk does not see those within it, but they see it.
                   if (*other == slot || (*other > slot && system.radius(*other) <= system.radius(slot)))
                     continue;
                   const Eigen::Vector2d way =
                       points[slot] - points[*other] - Eigen::Vector2d(shift * width, 0.0);
                   visit(std::min(slot, *other), std::max(slot, *other),
                         system.radius(slot) + system.radius(*other) - way.norm());
                 }
               });
}

/// The pour observer is called after this many disks: some hundred times a second.
constexpr std::size_t DISKS_PER_LOOK = 1024;

/// A disk's position at `time`, for the pour.
PlacedDisk placed(const SystemState& system, std::uint32_t slot, const FrameOfBase& base, double time)
{
  const Eigen::Vector2d position = positionAt(system.disk(slot), time, system.scene().gravity);
  const double s = base.positionInto(position).x();
  return {s - system.shape().width() * system.widthsOutside(s), base.into(position).y(), system.radius(slot)};
}

struct Poured
{
  PlacedDisk room;
  std::uint32_t species;
};

/// Finds room for a disk of each of these species; in the order along the base. The memory of the search, as
/// much as that of the disks, is freed before they are added.
/// @param own see pourDisks()
std::vector<Poured> findRoom(const SystemState& system, const std::vector<std::uint32_t>& species,
                             const FedDisk* own, const Stretch& stretch, double time, Random& random,
                             const PourObserver& observer)
{
  const SceneDefinition& scene = system.scene();
  const FrameOfBase base = system.motion().at(time);
  Pour pour({scene.base.width(), scene.boundary == Boundary::PERIODIC, stretch.from, stretch.to,
             scene.base.highest() + system.motion().displacementBound().norm() + scene.pour.drop_height},
            system.largestDiameter(), scene.contact.pair_collisions);
  for (const std::uint32_t slot : system.slots(true))
    pour.occupy(placed(system, slot, base, time));
  std::vector<Poured> poured;
  poured.reserve(species.size());
  for (const std::uint32_t kind : species)
  {
    const double radius =
        own != nullptr ? own->radius : system.sizes(kind).draw([&random] { return random.uniform(); });
    poured.push_back({pour.place(radius, random.uniform()), kind});
    if (observer && poured.size() % DISKS_PER_LOOK == 0)
      observer(poured.size(), species.size());
  }
  // Numbered along the base, so that neighbours are near each other in memory.
  std::stable_sort(poured.begin(), poured.end(),
                   [](const Poured& a, const Poured& b) { return a.room.s < b.room.s; });
  return poured;
}

void addPoured(SystemState& system, const Poured& poured, double mass, const FrameOfBase& base, double time)
{
  const SceneDefinition& scene = system.scene();
  const auto& [room, kind] = poured;
  const Eigen::Vector2d place = base.outOf({room.s + base.into(base.displacement).x(), room.n});
  Disk disk;
  disk.position.x() = place.x();
  disk.position.y() = place.y();
  disk.velocity.y() = -scene.pour.speed;
  disk.species = kind;
  disk.radius = room.radius;
  system.add(disk, propertiesOf(scene.species[kind], mass, room.radius), time);
}

/// @throws std::invalid_argument if a disk overlaps another or the base, or is outside the machine; the
/// message names the entries of `initial`
void refuseBadStart(const SystemState& system, double time)
{
  std::ostringstream message;
  const auto points = placesOnBase(system, time);
  for (std::uint32_t slot = 0; slot < points.size(); ++slot)
  {
    const double s = points[slot].x();
    if (s < 0.0 || s > system.shape().width())
    {
      message << "initial." << slot << " is outside the machine: its centre is at s = " << s
              << " m along the base, allowed is 0 to " << system.shape().width() << " m";
      throw std::invalid_argument(message.str());
    }
    const double gap = gapToBase(system, points[slot], system.radius(slot));
    if (-gap > toleratedOverlap(points[slot], system.disk(slot)))
    {
      message << "initial." << slot << " overlaps the base or a wall by " << -gap << " m";
      throw std::invalid_argument(message.str());
    }
  }
  if (!system.scene().contact.pair_collisions)
    return;
  double worst = 0.0;
  forEachNearPair(system, points,
                  [&](std::uint32_t first, std::uint32_t second, double overlap)
                  {
                    if (overlap <= std::max(worst, toleratedOverlap(points[first], system.disk(first))))
                      return;
                    worst = overlap;
                    message.str("");
                    message << "initial." << first << " and initial." << second << " overlap by " << overlap
                            << " m";
                  });
  if (worst > 0.0)
    throw std::invalid_argument(message.str());
}
}  // namespace

Audit audit(const SystemState& system, double time)
{
  Audit result;
  const auto points = placesOnBase(system, time);
  for (const std::uint32_t slot : system.slots(true))
  {
    const double gap = gapToBase(system, points[slot], system.radius(slot));
    result.largest_overlap = std::max(result.largest_overlap, -gap);
    if (gap <= -system.radius(slot))
      ++result.behind_surface;
  }
  if (system.scene().contact.pair_collisions)
    forEachNearPair(system, points,
                    [&](std::uint32_t, std::uint32_t, double overlap)
                    { result.largest_overlap = std::max(result.largest_overlap, overlap); });
  return result;
}

std::vector<std::uint32_t> pourOrder(const std::vector<SpeciesDefinition>& species, Random& random)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t s = 0; s < species.size(); ++s)
    order.insert(order.end(), static_cast<std::size_t>(species[s].count), s);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

std::uint32_t drawSpecies(const std::vector<SpeciesDefinition>& species, Random& random)
{
  double total = 0.0;
  for (const auto& s : species)
    total += s.share;
  double left = random.uniform() * total;
  for (std::uint32_t s = 0; s + 1 < species.size(); ++s)
  {
    left -= species[s].share;
    if (left < 0.0)
      return s;
  }
  return static_cast<std::uint32_t>(species.size() - 1);
}

void pourDisks(SystemState& system, const std::vector<std::uint32_t>& species, const Stretch& stretch,
               double time, Random& random, const PourObserver& observer, const FedDisk* own)
{
  const std::vector<Poured> all = findRoom(system, species, own, stretch, time, random, observer);
  if (all.size() > 1)  // exactly so many; for disks that are fed one by one this would copy all each time
    system.reserve(system.disks().size() + all.size());
  const FrameOfBase base = system.motion().at(time);
  for (const Poured& poured : all)
  {
    const double mass =
        own != nullptr ? own->mass : system.scene().species[poured.species].massOf(poured.room.radius);
    addPoured(system, poured, mass, base, time);
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
    disk.species = static_cast<std::uint32_t>(initial.species);
    const SpeciesDefinition& species = system.scene().species[initial.species];
    disk.radius = species.radius;
    system.add(disk, propertiesOf(species, disk.radius), time);
  }
  refuseBadStart(system, time);
}

}  // namespace ratchet_sieve
