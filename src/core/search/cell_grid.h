#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/processor.h"
#include "ratchet_sieve/core/state_archive.h"
#include "search/cell_blocks.h"
#include "search/cell_nest.h"

namespace ratchet_sieve
{

/// The cell list. Cells are at least as wide as the largest diameter, so that only disks in the same or
/// adjacent cells can touch; larger disks than that are in a CellNest. Columns along s, rows along n, in a
/// fixed frame. The outermost cells extend to infinity, except the columns of a periodic grid, which form a
/// ring. A ring of one column may extend beyond its ends by whole widths (laps): its disks are wrapped less
/// often, and may collide with any image of each other.
class CellGrid
{
public:
  struct Cell
  {
    std::int32_t column = 0;
    std::int32_t row = 0;

    void archive(StateArchive& state) { state(column, row); }
  };

  /// @param shape at least as wide as the first level and the margin; levels that fit into it become the
  /// first
  /// @param margin see CellNest
  /// @param laps widths by which a ring of one column extends beyond either end; 0 with more columns
  CellGrid(const CellShape& shape, const SizeLevels& levels, double margin, std::size_t count,
           std::int32_t laps = 0);

  /// @param radius if there are levels of sizes [m]
  void add(std::uint32_t slot, Cell cell, double radius = 0.0);
  void remove(std::uint32_t slot);
  void resize(std::size_t count);

  /// From now on, disks in columns of which any part is within `reach` of the ring's seam see all rows of
  /// the columns around them [m]. @pre levels() are empty
  void openSeam(double reach);

  bool atOpenSeam(Cell cell) const
  {
    return cell.column < open_columns_ || cell.column >= shape_.columns - open_columns_;
  }

  /// Whether a disk may see one that is at the open seam, or in the topmost row.
  bool seesOpenSeam(std::uint32_t slot) const
  {
    const Cell cell = cells_[slot];
    return cell.column <= open_columns_ || cell.column + 1 >= shape_.columns - open_columns_ ||
           cell.row + 2 >= shape_.rows;
  }

  Cell cellAt(double s, double n) const;
  Cell cellOf(std::uint32_t slot) const { return cells_[slot]; }
  std::int32_t columnOf(std::uint32_t slot) const { return cells_[slot].column; }

  /// Several threads may then move disks between cells of different columns at the same time.
  void reserveOverflow() { blocks_.reserveOverflow(cells_.size()); }

  bool periodic() const { return shape_.periodic; }
  std::int32_t columns() const { return shape_.columns; }
  std::int32_t rows() const { return shape_.rows; }
  std::int32_t laps() const { return laps_; }
  double columnStart(std::int32_t column) const { return column * shape_.side_s; }

  /// The left and the right edge of a column.
  double leftEdge(std::int32_t column) const { return columnStart(column) - laps_ * shape_.side_s; }
  double rightEdge(std::int32_t column) const { return columnStart(column + 1) + laps_ * shape_.side_s; }
  double rowStart(std::int32_t row) const { return row * shape_.side_n; }

  /// The cells around a cell: from (column + first_column, row + first_row) to (column + last_column, row +
  /// last_row).
  struct Surroundings
  {
    int first_column = -1;
    int last_column = 1;
    int first_row = -1;
    int last_row = 1;
  };

  /// The cells that become neighbours of a disk's cell when it crosses an edge; NONE: all.
  static Surroundings beyond(CellEdge edge);

  /// As below, for the disks that may touch a disk within their cells, or for those that may since it crossed
  /// an edge.
  template <typename Visit>
  void visit(std::uint32_t slot, CellEdge entered, std::vector<std::uint32_t>& list, Visit&& visit) const
  {
    const Cell cell = cells_[slot];
    if (nest_.empty())
    {
      const Surroundings whole{-1, 1, -shape_.rows, shape_.rows};
      return this->visit(cell, atOpenSeam(cell) ? whole : beyond(entered), list, visit);
    }
    const std::int32_t reach = nest_.reach(levels_[slot]);
    for (int shift = -1; shift <= 1; ++shift)
    {
      if (shift != 0 &&
          !(shape_.periodic && (shift < 0 ? cell.column < reach : cell.column + reach >= shape_.columns)))
        continue;
      const CellNest::Place place{levels_[slot], entered, cell.column - shift * shape_.columns, cell.row};
      const std::size_t count = nest_.collect(place, blocks_, list);
      if (count > 0)
        visit(list.data(), count, shift);
    }
  }

  /// Collects the disks in the cells around `cell` and calls visit(slots, count, shift) once for each value
  /// of `shift`: the number of widths by which the image in the grid is to the right of the disk. A ring with
  /// laps() gives a single list, for all shifts up to 2 laps() + 2 to either side.
  /// @param list buffer; grows as needed
  template <typename Visit>
  void visit(Cell cell, const Surroundings& around, std::vector<std::uint32_t>& list, Visit&& visit) const
  {
    const int first_row = std::max(cell.row + around.first_row, 0);
    const int last_row = std::min(cell.row + around.last_row, shape_.rows - 1);
    const int first_column = cell.column + around.first_column;
    const int last_column = cell.column + around.last_column;
    const auto visit_columns = [&](int first, int last, int shift)
    {
      if (first > last || first_row > last_row)
        return;
      const std::size_t count =
          blocks_.collect(index({first, first_row}), static_cast<std::size_t>(last - first) + 1,
                          static_cast<std::size_t>(last_row - first_row) + 1,
                          static_cast<std::size_t>(shape_.columns), list, 0);
      visit(list.data(), count, shift);
    };
    visit_columns(std::max(first_column, 0), std::min(last_column, shape_.columns - 1), 0);
    if (!shape_.periodic || laps_ > 0)
      return;
    if (first_column < 0)
      visit_columns(shape_.columns - 1, shape_.columns - 1, -1);
    if (last_column >= shape_.columns)
      visit_columns(0, 0, 1);
  }

  /// Prefetches what cellOf() reads.
  void prefetchCellOf(std::uint32_t slot) const { prefetch(cells_[slot]); }

  /// Prefetches what visit() reads of the cells around a disk, except those beyond the seam.
  void prefetchAround(std::uint32_t slot) const
  {
    const Cell cell = cells_[slot];
    for (int row = std::max(cell.row - 1, 0); row <= std::min(cell.row + 1, shape_.rows - 1); ++row)
      for (int column = std::max(cell.column - 1, 0); column <= std::min(cell.column + 1, shape_.columns - 1);
           ++column)
        blocks_.prefetchCell(index({column, row}));
  }

  void archive(StateArchive& state);

  /// The diameters of the levels of sizes; empty: a single one.
  const SizeLevels& levels() const { return nest_.levels(); }

private:
  std::size_t index(Cell cell) const
  {
    return static_cast<std::size_t>(cell.row) * shape_.columns + cell.column;
  }

  CellShape shape_;
  std::int32_t laps_;
  std::int32_t open_columns_ = 0;  ///< at either end of the ring; see openSeam()
  CellBlocks blocks_;
  std::vector<Cell> cells_;           ///< per disk
  CellNest nest_;                     ///< of larger disks
  std::vector<std::uint8_t> levels_;  ///< per disk, if there is a nest
};

}  // namespace ratchet_sieve
