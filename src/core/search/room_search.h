#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "search/standing_disks.h"

namespace ratchet_sieve
{

/// Finds the lowest room for disks of one radius, again and again while more and more disks stand there.
///
/// A heap has no room left but in a few narrow gaps, and room once taken stays taken. So what may be free is
/// kept: in cells, each a stretch of the base by a range of heights. A search visits those of its position,
/// from the lowest up. One that turns out to have no room there is halved along the base, and only the parts
/// that are not sure to be full are kept, as voxels are in random sequential addition (Zhang & Torquato,
/// Phys. Rev. E 88, 053312 (2013)). What is left under the surface becomes narrower with each visit, so that
/// a search visits a number of cells that grows as the logarithm of the heap's height.
class RoomSearch
{
public:
  /// @param lowest height at which a disk may stand [m]; @param radius of the disks [m]
  RoomSearch(double lowest, double radius, double column_width);

  double radius() const { return radius_; }

  /// The lowest height at which a disk at s touches none of those standing [m].
  double lowestFree(double s, const StandingDisks& standing);

private:
  struct Cell
  {
    HeightRange heights;
    double left;   ///< [m]
    double right;  ///< [m]
  };
  using Cells = std::vector<Cell>;  ///< of one bin, by their lower ends

  Cells& cellsAt(double s, double& clamped);
  void replace(Cells& cells, std::size_t at, const StandingDisks& standing, bool halved) const;

  double lowest_;
  double radius_;
  double bin_width_;
  std::unordered_map<std::size_t, Cells> bins_;  ///< along s; those that were visited
};

}  // namespace ratchet_sieve
