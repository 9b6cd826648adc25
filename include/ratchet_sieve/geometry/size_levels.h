#pragma once

#include <cstdint>
#include <vector>

namespace ratchet_sieve
{

/// The levels of nested cells: the disks of level 0 have a diameter up to diameters[0], those of the next
/// level up to diameters[1], and so on.
struct SizeLevels
{
  std::vector<double> diameters;  ///< increasing; the last is the largest of all [m]

  std::size_t count() const { return diameters.size(); }
  double largest() const { return diameters.back(); }

  /// @pre 2 radius <= largest()
  std::uint8_t of(double radius) const
  {
    std::uint8_t level = 0;
    while (level + std::size_t{1} < diameters.size() && 2.0 * radius > diameters[level])
      ++level;
    return level;
  }

  template <typename Archive>
  void archive(Archive& state)
  {
    state(diameters);
  }
};

/// Whether most disks are so much smaller than the largest that cells of its size would hold far too many.
bool areWide(double largest_diameter, double mean_square_diameter);

/// The levels for which a search is cheapest: a single one unless sizes are wide.
/// @param radii of the present disks [m]; @param largest_diameter that a disk may have [m]
SizeLevels cheapestLevels(const std::vector<double>& radii, double largest_diameter);

}  // namespace ratchet_sieve
