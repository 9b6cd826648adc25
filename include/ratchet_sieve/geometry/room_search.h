#pragma once

#include <cstddef>
#include <memory_resource>
#include <unordered_map>
#include <vector>

#include "ratchet_sieve/geometry/standing_disks.h"

namespace ratchet_sieve
{

/// Finds the lowest free position for disks of nearly one radius, again and again while disks are added.
///
/// A heap has free positions in a few narrow gaps only, and occupied positions stay occupied. So the possibly
/// free space is stored in cells: an interval along the base and a range of heights. A search visits the
/// cells at its position from the lowest up. A cell without a free position there is halved along the base,
/// and only the parts that are not guaranteed to be full are kept, like the voxels in random sequential
/// addition (Zhang & Torquato, Phys. Rev. E 88, 053312 (2013)). The gaps become narrower with each visit, so
/// that the number of cells per search grows as the logarithm of the heap's height.
class RoomSearch
{
public:
  /// @param lowest smallest height for a disk [m] @param radius of the smallest disks [m] @param memory
  /// outlives this
  RoomSearch(double lowest, double radius, double column_width, std::pmr::memory_resource& memory);

  /// Whether it is for disks of this radius [m]: what is full for the smallest is full for them, too, and
  /// little that is full is searched.
  bool serves(double radius) const;

  /// The lowest height at which a disk of this radius at s touches none of the placed disks [m].
  /// @param lowest allowed [m]
  double lowestFree(double s, double radius, double lowest, const StandingDisks& standing);

private:
  struct Cell
  {
    HeightRange heights;
    double left;   ///< [m]
    double right;  ///< [m]
  };
  using Cells = std::pmr::vector<Cell>;  ///< of one bin, ordered by their lower ends

  Cells& cellsAt(double s, double& clamped);
  void replace(Cells& cells, std::size_t at, const StandingDisks& standing, bool halved) const;

  double lowest_;
  double radius_;
  double bin_width_;
  std::pmr::unordered_map<std::size_t, Cells> bins_;  ///< along s; only bins that were visited
};

}  // namespace ratchet_sieve
