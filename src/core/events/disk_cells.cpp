#include "events/disk_cells.h"

#include <algorithm>
#include <cmath>

#include "ratchet_sieve/core/resolution.h"

namespace ratchet_sieve
{
namespace
{

/// Cells are wider than the largest diameter by this share, which leaves room for rounding.
constexpr double CELL_MARGIN = 0.005;

/// While a periodic base turns, its lattice turns against the cells: they are wider then by more
/// than it may, so that the grid need not be rebuilt at every other collision.
constexpr double TURNING_CELL_MARGIN = MachineState::LATTICE_MARGIN + CELL_MARGIN;

/// Beyond so many laps a disk is wrapped in any case: its images within reach are tested one by one.
constexpr double MOST_LAPS = 64.0;

}  // namespace

DiskCells::DiskCells(MachineState& state)
    : state_(state), grid_(makeGrid()), capacity_(state.disks().size()), built_for_(capacity_)
{
}

void DiskCells::rebuild(std::size_t count, double time)
{
  grid_ = makeGrid();
  grid_.resize(capacity_);
  built_for_ = count;
  for (std::uint32_t slot = 0; slot < count; ++slot)
    if (state_.active(slot))
      add(slot, time);
}

std::size_t DiskCells::reserve(std::size_t count)
{
  capacity_ = 2 * count;
  grid_.resize(capacity_);
  return capacity_;
}

void DiskCells::add(std::uint32_t slot, double time)
{
  state_.wrapIntoWidth(slot, inGrid(slot, time).s(), time);
  grid_.add(slot, cellNow(slot, time));
}

bool DiskCells::cross(std::uint32_t slot, Edge edge, double time)
{
  fit_.crossed();
  CellGrid::Cell cell = grid_.cellOf(slot);
  grid_.remove(slot);
  cell.column += edge == Edge::RIGHT ? 1 : edge == Edge::LEFT ? -1 : 0;
  cell.row += edge == Edge::UPPER ? 1 : edge == Edge::LOWER ? -1 : 0;
  const int laps = cell.column < 0 ? -1 : cell.column >= grid_.columns() ? 1 : 0;
  if (laps != 0)
  {
    if (grid_.laps() > 0)
      state_.wrapIntoWidth(slot, inGrid(slot, time).s(), time);
    else
      state_.wrap(slot, -laps, time);
    cell.column -= laps * grid_.columns();
    cell.row = cellNow(slot, time).row;
  }
  grid_.add(slot, cell);
  return laps != 0;
}

CellGrid::Surroundings DiskCells::beyond(Edge edge)
{
  CellGrid::Surroundings around;
  if (edge == Edge::LEFT)
    around.last_column = -1;
  if (edge == Edge::RIGHT)
    around.first_column = 1;
  if (edge == Edge::LOWER)
    around.last_row = -1;
  if (edge == Edge::UPPER)
    around.first_row = 1;
  return around;
}

bool DiskCells::endEpoch(std::uint64_t events, double time)
{
  const std::optional<double> searches = fit_.epochEnded(events, state_.activeCount());
  if (!searches)
    return false;
  std::vector<BasePoint> points;
  for (const std::uint32_t slot : state_.slots(true))
    points.push_back(inGrid(slot, time));
  const int spare_laps = state_.scene().boundary == Boundary::PERIODIC ? laps() : 0;
  const LayoutCosts costs(points, state_.sawtooth().width(), *searches / state_.epoch().length, spare_laps);
  return fit_.choose(costs, layerLayout(), leastSide());
}

CellGrid DiskCells::makeGrid()
{
  const SceneDefinition& scene = state_.scene();
  frame_ = state_.motion().at(state_.motion().segmentStart());
  const bool periodic = scene.boundary == Boundary::PERIODIC;
  const CellLayout layout = fit_.layout().value_or(layerLayout());
  const std::size_t count = std::max<std::size_t>(1, state_.activeCount());
  return CellGrid(scene.base.width(), layout.height, std::max(layout.smallest_side, leastSide()), count,
                  periodic, fit_.layout() ? laps() : 0);
}

/// The smallest side that cells may have [m].
double DiskCells::leastSide() const
{
  const bool lattice_turns = state_.scene().boundary == Boundary::PERIODIC && state_.motion().turning();
  return state_.largestDiameter() * (1.0 + (lattice_turns ? TURNING_CELL_MARGIN : CELL_MARGIN));
}

/// Cells for a shaken layer.
CellLayout DiskCells::layerLayout() const
{
  const SceneDefinition& scene = state_.scene();
  const double count = std::max<double>(1.0, static_cast<double>(state_.activeCount()));
  const double diameter = state_.largestDiameter();
  const double layers = count * diameter * diameter / scene.base.width();
  // As high as the shaken layer: what is poured from above it, or thrown out of it, is in the topmost row.
  const double height = scene.base.tooth_height + layers +
                        std::min(state_.motion().throwHeight(scene.gravity), scene.base.width());
  return {height, leastSide()};
}

/// By how many laps a disk may be outside of [0, W) before it has to be wrapped: positions there are still
/// fine enough for the smallest disk. On a base that turns images do not move as the disk does: none.
std::int32_t DiskCells::laps() const
{
  if (state_.motion().turning())
    return 0;
  const double farthest = farthestPlace(state_.smallestRadius()) / state_.sawtooth().width();
  return static_cast<std::int32_t>(std::clamp(std::floor(farthest) - 1.0, 0.0, MOST_LAPS));
}

CellGrid::Cell DiskCells::cellNow(std::uint32_t slot, double time) const
{
  const BasePoint p = inGrid(slot, time);
  return grid_.cellAt(p.s(), p.n());
}

}  // namespace ratchet_sieve
