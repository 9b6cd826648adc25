#include "events/disk_cells.h"

#include <algorithm>
#include <cmath>

#include "ratchet_sieve/core/resolution.h"

namespace ratchet_sieve
{
namespace
{

/// Cells are wider than the largest diameter by this fraction, to allow for rounding.
constexpr double CELL_MARGIN = 0.005;

/// While a periodic base turns, its lattice turns relative to the cells. Cells are then wider by more than
/// that rotation requires. Otherwise the grid would be rebuilt at every other collision.
constexpr double TURNING_CELL_MARGIN = SystemState::LATTICE_MARGIN + CELL_MARGIN;

/// Beyond this number of widths a disk is always wrapped: its images within reach are tested one by one.
constexpr double MOST_LAPS = 64.0;

/// Bound on the distance between a disk and its image in the grid [widths].
constexpr std::int32_t FARTHEST_IMAGE = 1 << 28;

}  // namespace

DiskCells::DiskCells(SystemState& state)
    : state_(state), capacity_(state.disks().size()), built_for_(capacity_), grid_(makeGrid())
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
  if (lattice_turns_)
    images_.resize(capacity_);
  return capacity_;
}

void DiskCells::add(std::uint32_t slot, double time)
{
  const double width = state_.sawtooth().width();
  if (lattice_turns_)
    images_[slot] -= static_cast<std::int32_t>(wholeWidths(inGrid(slot, time).s(), 1.0 / width));
  else
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
  cell.column -= laps * grid_.columns();
  const bool wraps = laps != 0 && !lattice_turns_;
  if (wraps)
  {
    if (grid_.laps() > 0)
      state_.wrapIntoWidth(slot, inGrid(slot, time).s(), time);
    else
      state_.wrap(slot, -laps, time);
    cell.row = cellNow(slot, time).row;
  }
  else if (laps != 0)
    images_[slot] -= laps;
  grid_.add(slot, cell);
  return wraps;
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

void DiskCells::archive(StateArchive& state)
{
  state(frame_, fit_, lattice_turns_, images_, grid_, capacity_, built_for_);
  if (!state.restoring())
    return;
  const double length =
      frame_.rotation.cosine * frame_.rotation.cosine + frame_.rotation.sine * frame_.rotation.sine;
  const double width = state_.sawtooth().width();
  const bool images_fit =
      lattice_turns_ == latticeTurns() && images_.size() == (lattice_turns_ ? capacity_ : 0) &&
      std::all_of(images_.begin(), images_.end(),
                  [](std::int32_t image) { return image >= -FARTHEST_IMAGE && image <= FARTHEST_IMAGE; });
  bool legal = images_fit && std::abs(length - 1.0) < 1e-9 && grid_.capacity() == capacity_ &&
               capacity_ >= state_.disks().size() && grid_.laps() <= static_cast<std::int32_t>(MOST_LAPS) &&
               grid_.periodic() == (state_.scene().boundary == Boundary::PERIODIC) &&
               std::abs(grid_.columnStart(grid_.columns()) - width) <= 1e-9 * width;
  for (std::uint32_t slot = 0; legal && slot < state_.disks().size(); ++slot)
    legal = !state_.active(slot) || grid_.holds(slot);
  state.require(legal, "its cells do not match its disks");
}

CellGrid DiskCells::makeGrid()
{
  const SceneDefinition& scene = state_.scene();
  frame_ = state_.motion().at(state_.motion().segmentStart());
  const bool periodic = scene.boundary == Boundary::PERIODIC;
  lattice_turns_ = latticeTurns();
  images_.assign(lattice_turns_ ? capacity_ : 0, 0);
  const CellLayout layout = fit_.layout().value_or(layerLayout());
  const std::size_t count = std::max<std::size_t>(1, state_.activeCount());
  return CellGrid(scene.base.width(), layout.height, std::max(layout.smallest_side, leastSide()), count,
                  periodic, fit_.layout() ? laps() : 0);
}

bool DiskCells::latticeTurns() const
{
  return state_.scene().boundary == Boundary::PERIODIC && state_.motion().turning();
}

/// The smallest allowed side of a cell [m].
double DiskCells::leastSide() const
{
  return state_.largestDiameter() * (1.0 + (lattice_turns_ ? TURNING_CELL_MARGIN : CELL_MARGIN));
}

/// Cells for a vibrated layer.
CellLayout DiskCells::layerLayout() const
{
  const SceneDefinition& scene = state_.scene();
  const double count = std::max<double>(1.0, static_cast<double>(state_.activeCount()));
  const double diameter = state_.largestDiameter();
  const double layers = count * diameter * diameter / scene.base.width();
  // The height of the vibrated layer: disks poured from above it or thrown out of it are in the topmost row.
  const double height = scene.base.tooth_height + layers +
                        std::min(state_.motion().throwHeight(scene.gravity), scene.base.width());
  return {height, leastSide()};
}

/// The number of widths by which a disk may be outside of [0, W) before it is wrapped. Within that distance,
/// positions resolve the smallest disk. 0 on a base that turns, because images then move relative to the
/// disk.
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
