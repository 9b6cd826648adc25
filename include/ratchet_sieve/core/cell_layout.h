#pragma once

#include <cstddef>
#include <vector>

#include "ratchet_sieve/core/contact_search.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Of cells: over which height there are rows, and how small a cell may be at most.
struct CellLayout
{
  double height = 0.0;         ///< [m]
  double smallest_side = 0.0;  ///< [m]

  void archive(StateArchive& state) { state(height, smallest_side); }
};

/// What cells cost a second: crossing their edges, and looking at the disks in them. Small cells are crossed
/// often, large ones hold many disks. Measured on the disks as they are now, so that it is right for a dense
/// layer as for a gas that fills any height.
class LayoutCosts
{
public:
  /// @param points of all disks, in the frame of the cells; @param width of the machine [m]
  /// @param events that search all cells around, of all disks [1/s]
  /// @param laps of a ring of one column; see CellGrid
  LayoutCosts(const std::vector<BasePoint>& points, double width, double events, int laps);

  /// In looks at a disk a second.
  double of(const CellLayout& layout) const;

  /// The best of cells with sides of 1, 2, 4, ... times the least, up to one cell for all.
  CellLayout cheapest(double least_side) const;

private:
  const std::vector<BasePoint>& points_;
  double width_;
  double events_;
  int laps_;
  double top_ = 0.0;  ///< under which nearly all disks are [m]
};

}  // namespace ratchet_sieve
