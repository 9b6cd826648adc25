#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/random.h"

namespace ratchet_sieve
{

/// A disk's place: s along the base as it stands now, for its ends and walls swing along with it; n
/// over the middle of its oscillation.
struct PlacedDisk
{
  double s = 0.0;  ///< [m]
  double n = 0.0;  ///< [m]
  double radius = 0.0;
};

/// Finds room for disks: each at a random place along the base, as low as the drop height and the disks
/// already there allow.
class Pour
{
public:
  /// @param base with the amplitude it has now, which bounds how high it reaches
  /// @param see_each_other false where disks do not collide: they may then lie over each other
  Pour(const BaseDefinition& base, Boundary boundary, double drop_height, double largest_diameter,
       bool see_each_other);

  /// Makes room in memory for so many disks.
  void reserve(std::size_t disks);

  /// A disk that is there already.
  void occupy(const PlacedDisk& disk);

  /// Places one more, and remembers it.
  PlacedDisk place(double radius, Random& random);

private:
  double lowestFree(double s, double radius, double lowest) const;
  std::size_t bucketAt(double s) const;

  struct Occupied
  {
    PlacedDisk disk;
    std::uint32_t before;  ///< the one that came into the bucket before this one
  };

  double width_;
  double lowest_underside_;
  bool periodic_;
  bool see_each_other_;
  double bucket_width_;
  std::vector<std::uint32_t>
      buckets_;  ///< along s, each at least the largest diameter wide: the last to come
  std::vector<Occupied> occupied_;
};

/// The order in which a scene's disks are poured: `count` of each species, shuffled.
std::vector<std::uint32_t> pourOrder(const std::vector<SpeciesDefinition>& species, Random& random);

/// A species drawn by the shares. @pre one share at least is positive
std::uint32_t drawSpecies(const std::vector<SpeciesDefinition>& species, Random& random);

}  // namespace ratchet_sieve
