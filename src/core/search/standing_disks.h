#pragma once

#include <cstddef>
#include <vector>

namespace ratchet_sieve
{

/// A disk's position: s along the base as it stands now, for its ends and walls swing along with it; n
/// over the middle of its oscillation.
struct PlacedDisk
{
  double s = 0.0;  ///< [m]
  double n = 0.0;  ///< [m]
  double radius = 0.0;
};

/// From one height to another [m]; the upper one may be infinite.
struct HeightRange
{
  double low = 0.0;
  double high = 0.0;
};

/// The disks above a base, in columns along s and by height in each, and the heights that they forbid to
/// another.
class StandingDisks
{
public:
  /// @param width of the base [m]
  StandingDisks(double width, bool periodic, double largest_diameter);

  void add(const PlacedDisk& disk);

  /// The lowest height, from range.low on, at which a disk of this radius at s touches none; one above
  /// range.high where the range has none.
  double lowestFree(double s, double radius, HeightRange range) const;

  /// What of the range is not sure to be forbidden to disks of this radius wherever they are between `left`
  /// and `right`, from the lowest up. @pre right - left <= columnWidth()
  std::vector<HeightRange> gaps(double left, double right, double radius, HeightRange range) const;

  double columnWidth() const { return column_width_; }

private:
  struct Column
  {
    mutable std::vector<PlacedDisk> disks;
    mutable std::size_t sorted = 0;  ///< so many of them are in the order of their heights
  };

  std::size_t columnAt(double s) const;
  static void sort(const Column& column);
  template <typename Visit>
  void visitColumns(std::size_t first, std::size_t last, HeightRange heights, Visit&& visit) const;

  double width_;
  bool periodic_;
  double largest_radius_;
  double column_width_;  ///< at least the largest diameter [m]
  std::vector<Column> columns_;
};

}  // namespace ratchet_sieve
