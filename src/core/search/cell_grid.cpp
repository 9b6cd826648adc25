#include "search/cell_grid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ratchet_sieve
{
namespace
{
/// With more cells per disk, most would be empty and cost memory and crossings.
constexpr double MAX_CELLS_PER_DISK = 1.5;
constexpr double MIN_CELLS = 64.0;
}  // namespace

CellShape::CellShape(double width, double height, double smallest_side, std::size_t count, bool ring)
    : periodic(ring)
{
  const double limit = std::max(MIN_CELLS, MAX_CELLS_PER_DISK * static_cast<double>(count));
  const double side = std::max(smallest_side, std::sqrt(width * height / limit));
  columns = static_cast<std::int32_t>(std::clamp(std::floor(width / side), 1.0, limit));
  rows = static_cast<std::int32_t>(std::clamp(std::floor(height / side), 1.0, limit));
  side_s = width / columns;
  side_n = side;
}

CellGrid::CellGrid(const CellShape& shape, const SizeLevels& levels, double margin, std::size_t count,
                   std::int32_t laps)
    : shape_(shape),
      laps_(shape.periodic && shape.columns == 1 ? laps : 0),
      blocks_(static_cast<std::size_t>(shape.columns) * shape.rows)
{
  SizeLevels larger = levels;
  while (larger.count() > 1 && larger.diameters[1] + margin <= std::min(shape.side_s, shape.side_n))
    larger.diameters.erase(larger.diameters.begin());
  if (larger.count() > 1)
  {
    nest_ = CellNest(shape, std::move(larger), margin);
    laps_ = 0;
  }
  resize(count);
}

void CellGrid::resize(std::size_t count)
{
  cells_.resize(count);
  if (!nest_.empty())
    levels_.resize(count);
}

void CellGrid::add(std::uint32_t slot, Cell cell, double radius)
{
  cells_[slot] = cell;
  const std::uint8_t level = nest_.empty() ? 0 : levels_[slot] = nest_.levels().of(radius);
  if (level > 0)
    return nest_.add(level, cell.column, cell.row, slot, radius);
  blocks_.add(index(cell), slot);
}

void CellGrid::remove(std::uint32_t slot)
{
  const Cell cell = cells_[slot];
  if (!nest_.empty() && levels_[slot] > 0)
    return nest_.remove(levels_[slot], cell.column, cell.row, slot);
  blocks_.remove(index(cell), slot);
}

void CellGrid::openSeam(double reach)
{
  open_columns_ =
      static_cast<std::int32_t>(std::min<double>(shape_.columns, std::floor(reach / shape_.side_s) + 1.0));
}

CellGrid::Surroundings CellGrid::beyond(CellEdge edge)
{
  Surroundings around;
  if (edge == CellEdge::LEFT)
    around.last_column = -1;
  if (edge == CellEdge::RIGHT)
    around.first_column = 1;
  if (edge == CellEdge::LOWER)
    around.last_row = -1;
  if (edge == CellEdge::UPPER)
    around.first_row = 1;
  return around;
}

void CellGrid::archive(StateArchive& state)
{
  state(shape_.periodic, laps_, shape_.columns, shape_.rows, shape_.side_s, shape_.side_n, blocks_, cells_,
        levels_);
  nest_.archive(state, shape_);
}

CellGrid::Cell CellGrid::cellAt(double s, double n) const
{
  const auto clamped = [](double position, std::int32_t count)
  { return static_cast<std::int32_t>(std::clamp(std::floor(position), 0.0, count - 1.0)); };
  return {clamped(s / shape_.side_s, shape_.columns), clamped(n / shape_.side_n, shape_.rows)};
}

}  // namespace ratchet_sieve
