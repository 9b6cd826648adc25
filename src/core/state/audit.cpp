#include "state/audit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "search/cell_grid.h"
#include "search/size_levels.h"
#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// Touching disks are legal: an overlap below this fraction of the radius, or of the resolution at the disk's
/// position, is rounding.
constexpr double TOUCHING = 1e-12;
constexpr double ROUNDING = 8.0 * std::numeric_limits<double>::epsilon();

/// Side of the audit's cells in units of the largest diameter. Fewer cells than in the engine are built
/// faster, and need less memory with a million disks.
constexpr double AUDIT_CELL = 2.0;

/// @param point the centre, in the frame of the base [m]
double toleratedOverlap(const Eigen::Vector2d& point, double radius)
{
  return TOUCHING * radius + ROUNDING * point.lpNorm<1>();
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
    const Disk now = flown(disk, time, system.scene().gravity);
    const Eigen::Vector2d point = base.positionInto(now.position);
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
  for (std::uint32_t slot = 0; slot < points.size(); ++slot)
    if (system.active(slot))
      top = std::max(top, points[slot].y());
  const SizeLevels levels = cheapestLevels(system.activeRadii(), system.largestDiameter());
  const CellShape shape(width, top, AUDIT_CELL * levels.diameters[0], points.size());
  CellGrid grid(shape, levels, 0.0, points.size(), periodic);
  for (std::uint32_t slot = 0; slot < points.size(); ++slot)
    if (system.active(slot))
      grid.add(slot, grid.cellAt(points[slot].x(), points[slot].y()), system.radius(slot));
  std::vector<std::uint32_t> list;
  for (std::uint32_t slot = 0; slot < points.size(); ++slot)
    if (system.active(slot))
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
}  // namespace

Audit audit(const SystemState& system, double time)
{
  Audit result;
  const auto points = placesOnBase(system, time);
  for (std::uint32_t slot = 0; slot < points.size(); ++slot)
  {
    if (!system.active(slot))
      continue;
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
    if (-gap > toleratedOverlap(points[slot], system.radius(slot)))
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
                    if (overlap <= std::max(worst, toleratedOverlap(points[first], system.radius(first))))
                      return;
                    worst = overlap;
                    message.str("");
                    message << "initial." << first << " and initial." << second << " overlap by " << overlap
                            << " m";
                  });
  if (worst > 0.0)
    throw std::invalid_argument(message.str());
}

}  // namespace ratchet_sieve
