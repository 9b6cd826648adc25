#include "events/disk_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ratchet_sieve/core/resolution.h"

namespace ratchet_sieve
{
namespace
{

/// Cells are wider than the largest diameter by this fraction, to allow for rounding.
constexpr double CELL_MARGIN = 0.005;

/// The part of it for the neighbours of nested cells; the rest is for the rounding of their reach.
constexpr double NEST_MARGIN = 0.5 * CELL_MARGIN;

/// Nested cells may be this many, whatever the number of disks: a large disk in a layer of small ones adds to
/// its height.
constexpr std::size_t MOST_NESTED_CELLS = 1 << 14;

/// Beyond this number of widths a disk is always wrapped: its images within reach are tested one by one.
constexpr double MOST_LAPS = 64.0;

}  // namespace

DiskCells::DiskCells(SystemState& state)
    : state_(state), capacity_(state.disks().size()), built_for_(capacity_), grid_(makeGrid())
{
}

void DiskCells::rebuild(std::size_t count, double time)
{
  grid_ = makeGrid();
  openSeam();
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

void DiskCells::add(std::uint32_t slot, double time, ThreadBuffer* buffer)
{
  if (lattice_turns_)
    images_[slot] -= static_cast<std::int32_t>(state_.widthsOutside(inGrid(slot, time).s()));
  else
    state_.wrapIntoWidth(slot, inGrid(slot, time).s(), time, buffer);
  grid_.add(slot, cellNow(slot, time), state_.radius(slot));
}

bool DiskCells::cross(std::uint32_t slot, Edge edge, double time, ThreadBuffer* buffer)
{
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
      state_.wrapIntoWidth(slot, inGrid(slot, time).s(), time, buffer);
    else
      state_.wrap(slot, -laps, time, buffer);
    cell.row = cellNow(slot, time).row;
  }
  else if (laps != 0)
    images_[slot] -= laps;
  grid_.add(slot, cell, state_.radius(slot));
  return wraps;
}

bool DiskCells::endEpoch(std::uint64_t events, double time)
{
  const std::optional<double> searches = layout_.epochEnded(events, state_.activeCount());
  if (!searches)
    return false;
  CellLayout::Disks disks{{}, state_.shape().width(), *searches / state_.epoch().length, 0};
  for (const std::uint32_t slot : state_.slots(true))
    disks.points.push_back(inGrid(slot, time));
  if (state_.scene().boundary == Boundary::PERIODIC)
    disks.laps = laps();
  return layout_.choose(disks, sizeForLayer(sizes()));
}

void DiskCells::archive(StateArchive& state)
{
  state(frame_, above_base_, layout_, lattice_turns_, images_, grid_, capacity_, built_for_);
  if (state.restoring())
    openSeam();
}

CellGrid DiskCells::makeGrid()
{
  const SceneDefinition& scene = state_.scene();
  const BaseMotion& motion = state_.motion();
  const bool periodic = scene.boundary == Boundary::PERIODIC;
  lattice_turns_ = periodic && motion.turning();
  // The frame of the base at the start of the motion's segment; in its middle if the lattice turns.
  const double start = motion.segmentStart();
  frame_ = motion.at(lattice_turns_ ? 0.5 * (start + *motion.nextChange()) : start);
  // Ends and walls are as high as any row, and a base that turns leans against the rows.
  above_base_ = periodic && !motion.turning()
                    ? state_.shape().relief() + 0.5 * state_.largestDiameter() + motion.reach().y()
                    : std::numeric_limits<double>::infinity();
  images_.assign(lattice_turns_ ? capacity_ : 0, 0);
  const Sizes now = sizes();
  const CellLayout::Size size = layout_.chosen().value_or(sizeForLayer(now));
  const double side = std::max(size.least_side, now.least_side);
  const std::size_t count = std::max<std::size_t>(1, state_.activeCount());
  const CellShape shape(scene.base.width(), size.height, side,
                        now.levels.count() > 1 ? std::max(count, MOST_NESTED_CELLS) : count, periodic);
  return CellGrid(shape, now.levels, NEST_MARGIN * now.levels.diameters[0] + latticeMargin(), count,
                  layout_.chosen() ? laps() : 0);
}

/// While a periodic base turns, its lattice turns relative to the cells, by up to this length [m].
double DiskCells::latticeMargin() const
{
  return lattice_turns_ ? state_.latticeMargin() : 0.0;
}

/// While the lattice turns, images across an end of the base rise or sink against the rows. Disks meet them
/// within a diameter of the end. The ends swing with the drive, the cells do not. The ends lean against the
/// columns: the higher, the farther. Disks so high that both are in the topmost row see each other anyway.
void DiskCells::openSeam()
{
  if (!lattice_turns_ || grid_.levels().count() > 0)
    return;
  const double rise = std::sin(state_.latticeTurn());
  const double width = state_.shape().width();
  const double top = grid_.rowStart(grid_.rows() - 1) + width * rise;
  const Eigen::Vector2d& swing = state_.motion().displacementBound();
  const double along =
      std::abs(frame_.rotation.cosine) * swing.x() + std::abs(frame_.rotation.sine) * swing.y();
  const double height = std::max(top / std::cos(state_.latticeTurn()), state_.shape().relief());
  grid_.openSeam(state_.largestDiameter() + state_.latticeMargin() + along + rise * (height + swing.norm()));
}

DiskCells::Sizes DiskCells::sizes() const
{
  const std::vector<double> radii = state_.activeRadii();
  double squares = 0.0;
  for (const double radius : radii)
    squares += 4.0 * radius * radius;
  Sizes sizes{cheapestLevels(radii, state_.largestDiameter()), squares, 0.0};
  // A nested grid is not searched in all rows at its seam.
  if (lattice_turns_ && !state_.wideSizes())
    sizes.levels = {{state_.largestDiameter()}};
  const double diameter = sizes.levels.diameters[0];
  if (sizes.levels.count() == 1)
    sizes.squares = std::max<double>(1.0, static_cast<double>(radii.size())) * diameter * diameter;
  // Otherwise the grid would be rebuilt at every other collision while the lattice turns.
  sizes.least_side = diameter * (1.0 + (latticeMargin() / diameter + CELL_MARGIN));
  return sizes;
}

/// Cells for a vibrated layer.
CellLayout::Size DiskCells::sizeForLayer(const Sizes& sizes) const
{
  const SceneDefinition& scene = state_.scene();
  const double layers = sizes.squares / scene.base.width();
  // The height of the vibrated layer: disks poured from above it or thrown out of it are in the topmost row.
  double height = state_.shape().relief() + layers +
                  std::min(state_.motion().throwHeight(scene.gravity), scene.base.width());
  // A large disk stands out of the layer. In the topmost row it would cover no cell.
  if (sizes.levels.count() > 1)
    height += sizes.levels.largest();
  return {height, sizes.least_side};
}

/// The number of widths by which a disk may be outside of [0, W) before it is wrapped. Within that distance,
/// positions resolve the smallest disk. 0 on a base that turns, because images then move relative to the
/// disk.
std::int32_t DiskCells::laps() const
{
  if (state_.motion().turning())
    return 0;
  const double farthest = farthestPlace(state_.smallestRadius()) / state_.shape().width();
  return static_cast<std::int32_t>(std::clamp(std::floor(farthest) - 1.0, 0.0, MOST_LAPS));
}

CellGrid::Cell DiskCells::cellNow(std::uint32_t slot, double time) const
{
  const BasePoint p = inGrid(slot, time);
  return grid_.cellAt(p.s(), p.n());
}

}  // namespace ratchet_sieve
