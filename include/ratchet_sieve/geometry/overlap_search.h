#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ratchet_sieve/geometry/size_levels.h"

namespace ratchet_sieve
{

/// A disk in the frame of the base [m].
struct OverlapDisk
{
  float s;
  float n;
  float radius;
};

/// Finds the disks that may overlap at one time. The disks are sorted into columns across the base, a little
/// wider than the largest diameter. A search tests a disk's own column and its two neighbours, which are
/// contiguous in memory. Positions are in the frame of the base and in single precision; radii are increased
/// by their rounding error. So all overlaps are found, and some pairs that nearly overlap.
///
/// On a periodic base, the columns at the ends are duplicated beyond the other end, as images.
class OverlapSearch
{
public:
  /// @param width of the base [m], @param largest_diameter of its disks [m]
  OverlapSearch(double width, double largest_diameter, bool periodic);

  /// Begins a new time, with room for slots below `count`.
  void begin(std::size_t count);

  /// Adds a disk at (s, n) [m] of the base. @pre each slot once, between begin() and sort()
  void place(std::uint32_t slot, double s, double n, double radius)
  {
    placed_.push_back({slot, columnAt(s), static_cast<float>(s), static_cast<float>(n),
                       static_cast<float>(radius + slack_)});
  }

  /// After all disks are placed.
  void sort();

  /// Moves a disk at the same time, after its flight was changed.
  void move(std::uint32_t slot, double s, double n);

  /// Calls visit(slot, other, shift) once for each pair of disks that may overlap; `shift`: which image of
  /// the other, in widths to its right. A disk may be paired with an image of itself.
  template <typename Visit>
  void forEachPair(Visit&& visit)
  {
    for (std::size_t column = 0; column < columns_; ++column)
      for (std::uint32_t row = starts_[column + 1]; row < starts_[column + 2]; ++row)
        visitHits(row, hitsIn(row, row + 1, starts_[column + 3]), visit);
  }

  /// Calls visit(slot, other, shift) for each disk that may overlap this one.
  template <typename Visit>
  void forEachAround(std::uint32_t slot, Visit&& visit)
  {
    const std::uint32_t row = row_of_[slot];
    const std::size_t column = columnAt(rows_.s[row]);
    visitHits(row, hitsIn(row, starts_[column], starts_[column + 3]), visit);
  }

  /// Calls visit(slot, other, shift) for each disk that may overlap this one, which is not among those placed
  /// and may be of any size. @param slot its own
  template <typename Visit>
  void forEachTouching(std::uint32_t slot, const OverlapDisk& disk, Visit&& visit)
  {
    const double reach = disk.radius + 1.0 / columns_per_length_;
    for (int lap = periodic_ ? -1 : 0; lap <= (periodic_ ? 1 : 0); ++lap)
    {
      const double s = disk.s + lap * width_;
      if (s + reach < 0.0 || s - reach > width_)
        continue;
      // Into the row that is beyond all that a search tests.
      const auto row = static_cast<std::uint32_t>(slots_.size() - 1);
      put(row, {slot, 0, 0.0F, disk.n, disk.radius}, static_cast<float>(s));
      const std::size_t hits =
          hitsIn(row, starts_[columnAt(s - reach) + 1], starts_[columnAt(s + reach) + 2]);
      for (std::size_t k = 0; k < hits; ++k)
        visit(slot, slots_[hits_[k]], -lap);
    }
  }

  OverlapDisk placed(std::uint32_t slot) const
  {
    const std::uint32_t row = row_of_[slot];
    return {rows_.s[row], rows_.n[row], rows_.radius[row]};
  }

private:
  struct Placed
  {
    std::uint32_t slot;
    std::uint32_t column;
    float s;
    float n;
    float radius;
  };

  std::uint32_t columnAt(double s) const
  {
    const double column = s * columns_per_length_;
    return column > 0.0 ? (column < last_column_ ? static_cast<std::uint32_t>(column)
                                                 : static_cast<std::uint32_t>(columns_ - 1))
                        : 0;
  }

  /// Tests a row against the rows in [begin, end), except itself, and puts those that overlap into hits_, in
  /// increasing order. @return their number
  std::size_t hitsIn(std::uint32_t row, std::uint32_t begin, std::uint32_t end);

  template <typename Visit>
  void visitHits(std::uint32_t row, std::size_t count, Visit&& visit) const
  {
    for (std::size_t k = 0; k < count; ++k)
      visit(slots_[row], slots_[hits_[k]], shiftOf(hits_[k]));
  }

  void put(std::uint32_t row, const Placed& disk, float s);

  /// Rows before the first disk are images one width to the left; rows after the last disk are images one
  /// width to the right.
  int shiftOf(std::uint32_t row) const { return row < first_ ? -1 : row < first_ + disks_ ? 0 : 1; }

  double width_;
  bool periodic_;
  std::size_t columns_;
  double columns_per_length_;
  double last_column_;
  double slack_;  ///< of single precision, at the base's width [m]

  std::vector<Placed> placed_;
  std::vector<std::uint32_t> starts_;  ///< first row of each column; includes the image columns at both ends
  std::uint32_t first_ = 0;            ///< row of the first disk
  std::uint32_t disks_ = 0;

  /// Columns of values, ordered by the columns of the base. Up to LANES values after the last row are read as
  /// well, and ignored.
  struct Rows
  {
    std::vector<float> s;
    std::vector<float> n;
    std::vector<float> radius;
  } rows_;
  std::vector<std::uint32_t> slots_;   ///< per row
  std::vector<std::uint32_t> row_of_;  ///< per slot
  std::vector<std::uint32_t> hits_;    ///< rows
};

/// An OverlapSearch for disks of wide sizes: one for each size level, and each disk tested against the
/// columns of the other levels. The levels change only the cost.
class OverlapLevels
{
public:
  /// See OverlapSearch.
  OverlapLevels(double width, double largest_diameter, bool periodic)
      : width_(width), largest_diameter_(largest_diameter), periodic_(periodic)
  {
  }

  void begin(std::size_t count)
  {
    placed_.clear();
    level_of_.resize(count);
  }

  void place(std::uint32_t slot, double s, double n, double radius)
  {
    placed_.push_back({slot, s, n, radius});
  }

  void sort();

  void move(std::uint32_t slot, double s, double n) { searches_[level_of_[slot]].move(slot, s, n); }

  template <typename Visit>
  void forEachPair(Visit&& visit)
  {
    for (OverlapSearch& search : searches_)
      search.forEachPair(visit);
    for (const Placed& disk : placed_)
      for (std::size_t finer = 0; finer < level_of_[disk.slot]; ++finer)
        touching(disk.slot, finer, visit);
  }

  template <typename Visit>
  void forEachAround(std::uint32_t slot, Visit&& visit)
  {
    for (std::size_t level = 0; level < searches_.size(); ++level)
      if (level == level_of_[slot])
        searches_[level].forEachAround(slot, visit);
      else
        touching(slot, level, visit);
  }

private:
  struct Placed
  {
    std::uint32_t slot;
    double s;
    double n;
    double radius;
  };

  template <typename Visit>
  void touching(std::uint32_t slot, std::size_t level, Visit&& visit)
  {
    searches_[level].forEachTouching(slot, searches_[level_of_[slot]].placed(slot), visit);
  }

  void chooseLevels();

  double width_;
  double largest_diameter_;
  bool periodic_;
  std::size_t chosen_for_ = 0;  ///< the number of disks for which the levels were chosen
  SizeLevels levels_;
  std::vector<OverlapSearch> searches_;  ///< per level
  std::vector<Placed> placed_;
  std::vector<std::uint8_t> level_of_;  ///< per slot
};

}  // namespace ratchet_sieve
