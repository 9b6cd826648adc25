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

/// Number and size of the cells in a machine of this `width` [m].
struct CellShape
{
  /// @param height covered by the rows [m]
  /// @param smallest_side of a cell: at least the largest diameter, with a margin [m]
  /// @param count number of disks, to keep the number of cells in proportion
  CellShape(double width, double height, double smallest_side, std::size_t count);

  std::int32_t columns = 1;
  std::int32_t rows = 1;
  double side_s = 0.0;  ///< [m]
  double side_n = 0.0;  ///< [m]
};

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

  /// Parameters as in CellShape.
  /// @param laps widths by which a ring of one column extends beyond either end; 0 with more columns
  CellGrid(double width, double height, double smallest_side, std::size_t count, bool periodic,
           std::int32_t laps = 0);

  /// With cells for disks of very different sizes.
  /// @param shape at least as wide as the first level and the margin; levels that fit into it become the
  /// first
  /// @param margin see CellNest
  CellGrid(const CellShape& shape, const SizeLevels& levels, double margin, std::size_t count, bool periodic,
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
    return cell.column < open_columns_ || cell.column >= columns_ - open_columns_;
  }

  /// Whether a disk may see one that is at the open seam, or in the topmost row.
  bool seesOpenSeam(std::uint32_t slot) const
  {
    const Cell cell = cells_[slot];
    return cell.column <= open_columns_ || cell.column + 1 >= columns_ - open_columns_ ||
           cell.row + 2 >= rows_;
  }

  Cell cellAt(double s, double n) const;
  Cell cellOf(std::uint32_t slot) const { return cells_[slot]; }

  /// Several threads may then move disks between cells of different columns at the same time.
  void reserveOverflow() { blocks_.reserveOverflow(cells_.size()); }

  bool periodic() const { return periodic_; }
  std::int32_t columns() const { return columns_; }
  std::int32_t rows() const { return rows_; }
  std::int32_t laps() const { return laps_; }
  double columnStart(std::int32_t column) const { return column * side_s_; }

  /// The left and the right edge of a column.
  double leftEdge(std::int32_t column) const { return columnStart(column) - laps_ * side_s_; }
  double rightEdge(std::int32_t column) const { return columnStart(column + 1) + laps_ * side_s_; }
  double rowStart(std::int32_t row) const { return row * side_n_; }

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
      return this->visit(cell, atOpenSeam(cell) ? Surroundings{-1, 1, -rows_, rows_} : beyond(entered), list,
                         visit);
    const std::int32_t reach = nest_.reach(levels_[slot]);
    for (int shift = -1; shift <= 1; ++shift)
    {
      if (shift != 0 && !(periodic_ && (shift < 0 ? cell.column < reach : cell.column + reach >= columns_)))
        continue;
      const std::size_t count =
          collectNested({levels_[slot], entered, cell.column - shift * columns_, cell.row}, list);
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
    const int last_row = std::min(cell.row + around.last_row, rows_ - 1);
    const int first_column = cell.column + around.first_column;
    const int last_column = cell.column + around.last_column;
    const auto visit_columns = [&](int first, int last, int shift)
    {
      std::size_t count = 0;
      for (int row = first_row; row <= last_row; ++row)
        for (int column = first; column <= last; ++column)
          count = blocks_.collect(index({column, row}), list, count);
      visit(list.data(), count, shift);
    };
    visit_columns(std::max(first_column, 0), std::min(last_column, columns_ - 1), 0);
    if (!periodic_ || laps_ > 0)
      return;
    if (first_column < 0)
      visit_columns(columns_ - 1, columns_ - 1, -1);
    if (last_column >= columns_)
      visit_columns(0, 0, 1);
  }

  /// Prefetches what cellOf() reads.
  void prefetchCellOf(std::uint32_t slot) const { prefetch(cells_[slot]); }

  /// Prefetches what visit() reads of the cells around one, except those beyond the seam.
  void prefetchAround(Cell cell) const
  {
    for (int row = std::max(cell.row - 1, 0); row <= std::min(cell.row + 1, rows_ - 1); ++row)
      for (int column = std::max(cell.column - 1, 0); column <= std::min(cell.column + 1, columns_ - 1);
           ++column)
        blocks_.prefetchCell(index({column, row}));
  }

  void archive(StateArchive& state);

  /// The diameters of the levels of sizes; empty: a single one.
  const SizeLevels& levels() const { return nest_.levels(); }

private:
  CellNest::Lattice lattice() const { return {periodic_, columns_, rows_, side_s_, side_n_}; }
  std::size_t collectNested(const CellNest::Place& place, std::vector<std::uint32_t>& list) const;

  std::size_t index(Cell cell) const { return static_cast<std::size_t>(cell.row) * columns_ + cell.column; }

  bool periodic_;
  std::int32_t laps_;
  std::int32_t columns_;
  std::int32_t rows_;
  double side_s_;
  double side_n_;
  std::int32_t open_columns_ = 0;  ///< at either end of the ring; see openSeam()
  CellBlocks blocks_;
  std::vector<Cell> cells_;           ///< per disk
  CellNest nest_;                     ///< of larger disks
  std::vector<std::uint8_t> levels_;  ///< per disk, if there is a nest
};

}  // namespace ratchet_sieve
