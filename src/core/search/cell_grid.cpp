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

CellShape::CellShape(double width, double height, double smallest_side, std::size_t count)
{
  const double limit = std::max(MIN_CELLS, MAX_CELLS_PER_DISK * static_cast<double>(count));
  const double side = std::max(smallest_side, std::sqrt(width * height / limit));
  columns = static_cast<std::int32_t>(std::clamp(std::floor(width / side), 1.0, limit));
  rows = static_cast<std::int32_t>(std::clamp(std::floor(height / side), 1.0, limit));
  side_s = width / columns;
  side_n = side;
}

CellGrid::CellGrid(double width, double height, double smallest_side, std::size_t count, bool periodic,
                   std::int32_t laps)
    : CellGrid(CellShape(width, height, smallest_side, count), {}, 0.0, count, periodic, laps)
{
}

CellGrid::CellGrid(const CellShape& shape, const SizeLevels& levels, double margin, std::size_t count,
                   bool periodic, std::int32_t laps)
    : periodic_(periodic),
      laps_(periodic && shape.columns == 1 ? laps : 0),
      columns_(shape.columns),
      rows_(shape.rows),
      side_s_(shape.side_s),
      side_n_(shape.side_n),
      blocks_(static_cast<std::size_t>(columns_) * rows_)
{
  SizeLevels larger = levels;
  while (larger.count() > 1 && larger.diameters[1] + margin <= std::min(side_s_, side_n_))
    larger.diameters.erase(larger.diameters.begin());
  if (larger.count() > 1)
  {
    nest_ = CellNest(lattice(), std::move(larger), margin);
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
  open_columns_ = static_cast<std::int32_t>(std::min<double>(columns_, std::floor(reach / side_s_) + 1.0));
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

std::size_t CellGrid::collectNested(const CellNest::Place& place, std::vector<std::uint32_t>& list) const
{
  std::size_t count = 0;
  if (place.level == 0)
  {
    const Surroundings around = beyond(place.entered);
    const int first_column = std::max(place.column + around.first_column, 0);
    const int last_column = std::min(place.column + around.last_column, columns_ - 1);
    const int first_row = std::max(place.row + around.first_row, 0);
    const int last_row = std::min(place.row + around.last_row, rows_ - 1);
    for (int row = first_row; row <= last_row; ++row)
      for (int column = first_column; column <= last_column; ++column)
        count = blocks_.collect(index({column, row}), list, count);
  }
  return nest_.collect(place, blocks_, list, count);
}

void CellGrid::archive(StateArchive& state)
{
  state(periodic_, laps_, columns_, rows_, side_s_, side_n_, blocks_, cells_, levels_);
  nest_.archive(state, lattice());
}

CellGrid::Cell CellGrid::cellAt(double s, double n) const
{
  const auto clamped = [](double position, std::int32_t count)
  { return static_cast<std::int32_t>(std::clamp(std::floor(position), 0.0, count - 1.0)); };
  return {clamped(s / side_s_, columns_), clamped(n / side_n_, rows_)};
}

}  // namespace ratchet_sieve
