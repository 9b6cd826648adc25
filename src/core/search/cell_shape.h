#pragma once

#include <cstddef>
#include <cstdint>

namespace ratchet_sieve
{

/// The edge by which a disk leaves a cell.
enum class CellEdge : std::uint8_t
{
  NONE,
  LEFT,
  RIGHT,
  LOWER,
  UPPER
};

/// Number and size of the cells of a CellGrid in a machine of this `width` [m].
struct CellShape
{
  /// @param height covered by the rows [m]
  /// @param smallest_side of a cell: at least the largest diameter, with a margin [m]
  /// @param count number of disks, to keep the number of cells in proportion
  /// @param ring whether the columns form a ring
  CellShape(double width, double height, double smallest_side, std::size_t count, bool ring = false);

  CellShape() = default;

  bool periodic = false;  ///< the columns form a ring
  std::int32_t columns = 1;
  std::int32_t rows = 1;
  double side_s = 0.0;  ///< [m]
  double side_n = 0.0;  ///< [m]
};

}  // namespace ratchet_sieve
