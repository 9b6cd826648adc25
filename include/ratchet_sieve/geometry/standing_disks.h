#pragma once

#include <cstddef>
#include <memory_resource>
#include <vector>

namespace ratchet_sieve
{

/// A disk's position: s along the base in its present position, because ends and walls move with it; n above
/// the mean position of its oscillation.
struct PlacedDisk
{
  double s = 0.0;  ///< [m]
  double n = 0.0;  ///< [m]
  double radius = 0.0;
};

/// A range of heights [m]; the upper end may be infinite.
struct HeightRange
{
  double low = 0.0;
  double high = 0.0;
};

/// The placed disks above a base and the heights that they exclude for another disk. In classes of sizes, so
/// that a search for room among small disks does not read as far as a large one reaches; each class in
/// columns along s, ordered by height.
class StandingDisks
{
public:
  /// @param width of the base [m] @param memory outlives this
  StandingDisks(double width, bool periodic, double largest_diameter, std::pmr::memory_resource& memory);

  void add(const PlacedDisk& disk);

  /// The lowest height, from range.low on, at which a disk of this radius at s touches none; a value above
  /// range.high if there is none in the range.
  double lowestFree(double s, double radius, HeightRange range) const;

  /// The parts of the range that are not excluded for disks of this radius at every s between `left` and
  /// `right`, from the lowest up.
  std::vector<HeightRange> gaps(double left, double right, double radius, HeightRange range) const;

  /// At least the largest diameter [m].
  double columnWidth() const { return width_ / columnsFor(2.0 * largest_radius_); }

private:
  struct Column
  {
    explicit Column(std::pmr::memory_resource& memory) : disks(&memory) {}

    mutable std::pmr::vector<PlacedDisk> disks;
    mutable std::size_t sorted = 0;  ///< the first ones, ordered by height
  };

  /// Disks between this radius and half of it.
  struct SizeClass
  {
    double radius = 0.0;
    double column_width = 0.0;  ///< at least the largest diameter [m]
    std::vector<Column> columns;
  };

  double columnsFor(double diameter) const;
  SizeClass& classOf(double radius);
  static std::ptrdiff_t columnAt(const SizeClass& of, double s);
  static void sort(const Column& column);
  template <typename Visit>
  void visitReach(double left, double right, double radius, HeightRange heights, Visit&& visit) const;

  double width_;
  bool periodic_;
  double largest_radius_;
  std::pmr::memory_resource& memory_;
  std::vector<SizeClass> classes_;  ///< from the largest down, as far as there are disks
};

}  // namespace ratchet_sieve
