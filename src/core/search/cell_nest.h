#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"
#include "ratchet_sieve/geometry/size_levels.h"
#include "search/cell_blocks.h"
#include "search/cell_shape.h"

namespace ratchet_sieve
{

/// The larger disks of a cell grid, by levels of their sizes (Ogarko & Luding, Comput. Phys. Commun. 183, 931
/// (2012)). Every disk has a cell of the grid, whose sides suit the smallest ones, and crosses its edges. The
/// smallest are listed there (level 0); those of a higher level in buckets of 2, 4, 8, ... cells a side.
///
/// Two disks are neighbours if the distance of their cells is within the reach of their two levels: the sum
/// of the largest radii, and a margin. So whichever begins a flight or crosses an edge finds the other by the
/// same rule. Of cells that a large disk covers wholly, nothing is read.
class CellNest
{
public:
  /// Without larger disks.
  CellNest() = default;

  /// @param levels in which the cells' sides are at least the first diameter and the margin
  /// @param margin by which a distance of two disks may be less than their positions in the cells say [m]
  CellNest(const CellShape& shape, SizeLevels levels, double margin);

  /// Whether there is only level 0.
  bool empty() const { return larger_.empty(); }

  const SizeLevels& levels() const { return levels_; }

  void add(std::uint8_t level, std::int32_t column, std::int32_t row, std::uint32_t slot, double radius);
  void remove(std::uint8_t level, std::int32_t column, std::int32_t row, std::uint32_t slot);

  /// Largest difference of columns between a disk of a level and any neighbour.
  std::int32_t reach(std::uint8_t level) const { return reaches_[level]; }

  /// Where a search begins: the disk's cell and level. A column outside of the grid is that of an image.
  struct Place
  {
    std::uint8_t level;
    CellEdge entered;  ///< only what became a neighbour when the disk crossed this edge; NONE: all
    std::int32_t column;
    std::int32_t row;
  };

  /// Puts all neighbours into the list. @param smallest the disks of level 0, per cell
  /// @return their number
  std::size_t collect(const Place& place, const CellBlocks& smallest, std::vector<std::uint32_t>& list) const;

  std::size_t bucket(std::uint8_t level, std::int32_t column, std::int32_t row) const
  {
    const Level& of = larger_[level - 1];
    return static_cast<std::size_t>(row >> of.shift) * of.columns +
           static_cast<std::size_t>(column >> of.shift);
  }

  void archive(StateArchive& state, const CellShape& shape);

private:
  /// Per difference of rows: the largest difference of columns; nothing beyond the last.
  using Extent = std::vector<std::int32_t>;

  struct Level
  {
    int shift = 0;            ///< a bucket is 2^shift cells wide and high
    std::size_t columns = 0;  ///< of buckets
    CellBlocks blocks;        ///< per bucket
    std::uint32_t disks = 0;
    double smallest_radius = 0.0;  ///< of its disks so far [m]
    Extent covered;                ///< cells within any of its disks, whatever its position in its own

    void archive(StateArchive& state) { state(blocks, disks, smallest_radius); }
  };

  /// Cells or buckets to be read.
  struct Buckets
  {
    const CellBlocks* blocks;
    int shift;
    std::size_t columns;
  };

  void build(const CellShape& shape);
  const Extent& extent(std::size_t a, std::size_t b) const { return extents_[a * levels_.count() + b]; }
  Extent extentOf(double reach) const;
  Extent coveredBy(double radius) const;
  /// Columns from `first` to `last`; none if that is smaller.
  struct Span
  {
    std::int32_t first;
    std::int32_t last;
  };

  /// The columns of fine cells that a row of buckets is read for, and those of them that need not be read.
  struct Columns
  {
    Span read;
    Span skipped;
  };

  Columns columnsOf(const Place& place, std::int32_t first, std::int32_t last, const Extent& extent,
                    const Extent& covered) const;
  bool isBounded(const Place& place) const;
  std::size_t collect(const Place& place, const Buckets& buckets, const Extent& extent, const Extent& covered,
                      std::vector<std::uint32_t>& list, std::size_t count) const;

  CellShape shape_;
  SizeLevels levels_;
  double margin_ = 0.0;  ///< [m]
  std::vector<Level> larger_;
  std::vector<Extent> extents_;        ///< of neighbours, per two levels
  std::vector<std::int32_t> reaches_;  ///< per level
};

}  // namespace ratchet_sieve
