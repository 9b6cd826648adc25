#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Cells at least a largest diameter wide, so that disks in cells that do not touch cannot touch
/// either. Columns along s, rows along n, in a frame that stands still. The outermost cells go on
/// for ever, but for the columns of a periodic grid, which close to a ring.
class CellGrid
{
public:
  struct Cell
  {
    std::int32_t column = 0;
    std::int32_t row = 0;

    void archive(StateArchive& state) { state(column, row); }
  };

  /// Where a neighbouring column's disks stand as seen from here: shifted by this many widths.
  struct Neighbour
  {
    std::size_t cell = 0;
    int shift = 0;
  };

  /// @param width of the machine [m]; @param height over which to lay rows [m]
  /// @param smallest_side of a cell: the largest diameter, with its margin [m]
  /// @param count of disks, to keep the number of cells in proportion
  CellGrid(double width, double height, double smallest_side, std::size_t count, bool periodic);

  void add(std::uint32_t id, Cell cell);
  void remove(std::uint32_t id);
  void resize(std::size_t count);

  Cell cellAt(double s, double n) const;
  Cell cellOf(std::uint32_t id) const { return cells_[id]; }

  bool periodic() const { return periodic_; }
  std::int32_t columns() const { return columns_; }
  std::int32_t rows() const { return rows_; }
  double columnStart(std::int32_t column) const { return column * side_s_; }
  double rowStart(std::int32_t row) const { return row * side_n_; }

  /// Calls visit(id, shift) for every disk in the cells from (column + first_column, row + first_row)
  /// to (column + last_column, row + last_row) around `cell`, each offset in [-1, 1]. `shift` is how
  /// many widths the disk's image lies to the right of the disk.
  template <typename Visit>
  void visit(Cell cell, int first_column, int last_column, int first_row, int last_row, Visit&& visit) const
  {
    for (int dc = first_column; dc <= last_column; ++dc)
    {
      std::int32_t column = cell.column + dc;
      int shift = 0;
      if (column < 0 || column >= columns_)
      {
        if (!periodic_)
          continue;
        shift = column < 0 ? -1 : 1;
        column -= shift * columns_;
      }
      for (int dr = first_row; dr <= last_row; ++dr)
      {
        const std::int32_t row = cell.row + dr;
        if (row < 0 || row >= rows_)
          continue;
        for (std::uint32_t id = heads_[index({column, row})]; id != NONE; id = links_[id].next)
          visit(id, shift);
      }
    }
  }

  void archive(StateArchive& state)
  {
    state(periodic_, columns_, rows_, side_s_, side_n_, heads_, links_, cells_);
  }

private:
  static constexpr std::uint32_t NONE = 0xffffffff;

  struct Link
  {
    std::uint32_t next = NONE;
    std::uint32_t previous = NONE;

    void archive(StateArchive& state) { state(next, previous); }
  };

  std::size_t index(Cell cell) const { return static_cast<std::size_t>(cell.row) * columns_ + cell.column; }

  bool periodic_;
  std::int32_t columns_ = 1;
  std::int32_t rows_ = 1;
  double side_s_ = 0.0;
  double side_n_ = 0.0;
  std::vector<std::uint32_t> heads_;  ///< per cell
  std::vector<Link> links_;           ///< per disk
  std::vector<Cell> cells_;           ///< per disk
};

}  // namespace ratchet_sieve
