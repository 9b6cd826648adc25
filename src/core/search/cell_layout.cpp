#include "search/cell_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "search/cell_shape.h"

namespace ratchet_sieve
{
namespace
{
/// Cost of a cell crossing in units of pair evaluations, without the pairs beyond the edge: about 120 ns to 7
/// ns.
constexpr double EVALUATIONS_PER_EDGE = 20.0;

/// Cost of evaluating all images on a ring (PeriodicImageSearch), in units of pair evaluations.
constexpr double EVALUATIONS_PER_RING = 2.0;

/// Rows extend to this many mean heights: 95 % of all disks are below if the density follows the barometric
/// formula.
constexpr double MEAN_HEIGHTS = 3.0;

/// Events per disk between two evaluations of the layout: an evaluation costs no more than one event per
/// disk.
constexpr std::uint64_t EVENTS_BETWEEN_EVALUATIONS = 16;

/// With more crossings than this per other event, cells are too small. A vibrated layer has 0.4.
constexpr std::uint64_t MANY_CROSSINGS = 2;

/// The grid is rebuilt if that reduces the cost to this fraction; a smaller gain would not pay for the
/// rebuilding.
constexpr double WORTH_REBUILDING = 0.7;

/// In pair evaluations per second.
double costOf(const CellLayout::Size& size, const CellLayout::Disks& of)
{
  const CellShape cells(of.width, size.height, size.least_side, of.points.size());
  std::vector<double> disks(static_cast<std::size_t>(cells.rows));
  double crossings = 0.0;
  for (const BasePoint& point : of.points)
  {
    const double row = std::clamp(std::floor(point.n() / cells.side_n), 0.0, cells.rows - 1.0);
    disks[static_cast<std::size_t>(row)] += 1.0;
    crossings +=
        std::abs(point.velocity.x()) / (cells.columns > 1 ? cells.side_s : of.width * (1.0 + 2.0 * of.laps));
    if (row + 1.0 < cells.rows)
      crossings += std::abs(point.velocity.y()) / cells.side_n;
  }
  double together = 0.0;
  for (const double in_row : disks)
    together += in_row * in_row / cells.columns;
  const double rows = std::min<double>(3.0, cells.rows);
  const double columns = std::min<double>(3.0, cells.columns);
  const double ring = of.laps > 0 && cells.columns == 1 ? EVALUATIONS_PER_RING : 1.0;
  const double evaluations = ring * rows * columns * together / static_cast<double>(of.points.size());
  return of.events * evaluations + crossings * (EVALUATIONS_PER_EDGE + evaluations / 3.0);
}
}  // namespace

std::optional<double> CellLayout::epochEnded(std::uint64_t events, std::size_t disks)
{
  ++epochs_;
  const std::uint64_t since = events - events_before_;
  if (disks == 0 || since < EVENTS_BETWEEN_EVALUATIONS * disks)
    return std::nullopt;
  const std::uint64_t others = since - crossings_;
  const bool evaluate = chosen_ || crossings_ > MANY_CROSSINGS * others;
  const double others_per_epoch = static_cast<double>(others) / epochs_;
  events_before_ = events;
  crossings_ = 0;
  epochs_ = 0;
  return evaluate ? std::optional<double>(others_per_epoch) : std::nullopt;
}

bool CellLayout::choose(const Disks& disks, const Size& of_layer)
{
  // Nearly all disks are below this height.
  double top = 0.0;
  for (const BasePoint& point : disks.points)
    top += std::max(0.0, point.n());
  top *= MEAN_HEIGHTS / static_cast<double>(std::max<std::size_t>(1, disks.points.size()));
  Size best{top, of_layer.least_side};
  double least = costOf(best, disks);
  for (double side = 2.0 * of_layer.least_side; side < 2.0 * std::max(disks.width, top); side *= 2.0)
    if (const double cost = costOf({top, side}, disks); cost < least)
    {
      least = cost;
      best.least_side = side;
    }
  const double cost_of_layer = costOf(of_layer, disks);
  if (std::min(cost_of_layer, least) > WORTH_REBUILDING * costOf(chosen_.value_or(of_layer), disks))
    return false;
  chosen_ = cost_of_layer <= least ? std::nullopt : std::optional<Size>(best);
  return true;
}

}  // namespace ratchet_sieve
