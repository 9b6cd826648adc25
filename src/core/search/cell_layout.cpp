#include "search/cell_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "search/cell_grid.h"

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
}  // namespace

LayoutCosts::LayoutCosts(const std::vector<BasePoint>& points, double width, double events, int laps)
    : points_(points), width_(width), events_(events), laps_(laps)
{
  for (const BasePoint& point : points_)
    top_ += std::max(0.0, point.n());
  top_ *= MEAN_HEIGHTS / static_cast<double>(std::max<std::size_t>(1, points_.size()));
}

double LayoutCosts::of(const CellLayout& layout) const
{
  const CellShape cells(width_, layout.height, layout.smallest_side, points_.size());
  std::vector<double> disks(static_cast<std::size_t>(cells.rows));
  double crossings = 0.0;
  for (const BasePoint& point : points_)
  {
    const double row = std::clamp(std::floor(point.n() / cells.side_n), 0.0, cells.rows - 1.0);
    disks[static_cast<std::size_t>(row)] += 1.0;
    crossings +=
        std::abs(point.velocity.x()) / (cells.columns > 1 ? cells.side_s : width_ * (1.0 + 2.0 * laps_));
    if (row + 1.0 < cells.rows)
      crossings += std::abs(point.velocity.y()) / cells.side_n;
  }
  double together = 0.0;
  for (const double in_row : disks)
    together += in_row * in_row / cells.columns;
  const double rows = std::min<double>(3.0, cells.rows);
  const double columns = std::min<double>(3.0, cells.columns);
  const double ring = laps_ > 0 && cells.columns == 1 ? EVALUATIONS_PER_RING : 1.0;
  const double evaluations = ring * rows * columns * together / static_cast<double>(points_.size());
  return events_ * evaluations + crossings * (EVALUATIONS_PER_EDGE + evaluations / 3.0);
}

CellLayout LayoutCosts::cheapest(double least_side) const
{
  CellLayout best{top_, least_side};
  double least = of(best);
  for (double side = 2.0 * least_side; side < 2.0 * std::max(width_, top_); side *= 2.0)
  {
    const CellLayout layout{top_, side};
    const double cost = of(layout);
    if (cost >= least)
      continue;
    least = cost;
    best = layout;
  }
  return best;
}

std::optional<double> CellFit::epochEnded(std::uint64_t events, std::size_t disks)
{
  ++epochs_;
  const std::uint64_t since = events - events_before_;
  if (disks == 0 || since < EVENTS_BETWEEN_EVALUATIONS * disks)
    return std::nullopt;
  const std::uint64_t others = since - crossings_;
  const bool evaluate = layout_ || crossings_ > MANY_CROSSINGS * others;
  const double others_per_epoch = static_cast<double>(others) / epochs_;
  events_before_ = events;
  crossings_ = 0;
  epochs_ = 0;
  return evaluate ? std::optional<double>(others_per_epoch) : std::nullopt;
}

bool CellFit::choose(const LayoutCosts& costs, const CellLayout& for_layer, double least_side)
{
  const double now = costs.of(layout_.value_or(for_layer));
  const double of_layer = costs.of(for_layer);
  const CellLayout other = costs.cheapest(least_side);
  const double of_other = costs.of(other);
  if (std::min(of_layer, of_other) > WORTH_REBUILDING * now)
    return false;
  layout_ = of_layer <= of_other ? std::nullopt : std::optional<CellLayout>(other);
  return true;
}

}  // namespace ratchet_sieve
