#pragma once

#include <cstdint>
#include <vector>

#include "model/random.h"
#include "ratchet_sieve/core/definition.h"
#include "search/room_search.h"
#include "search/standing_disks.h"

namespace ratchet_sieve
{

/// Finds room for disks: each at a random place along the base, as low as the drop height and the disks
/// already there allow.
class Pour
{
public:
  /// @param base with the amplitude it has now, which bounds how high it reaches
  /// @param see_each_other false where disks do not collide: they may then lie over each other
  Pour(const BaseDefinition& base, Boundary boundary, double drop_height, double largest_diameter,
       bool see_each_other);

  /// A disk that is there already.
  void occupy(const PlacedDisk& disk);

  /// Places one more, and remembers it.
  PlacedDisk place(double radius, Random& random);

private:
  RoomSearch& searchFor(double radius);

  double width_;
  double lowest_underside_;
  bool periodic_;
  bool see_each_other_;
  StandingDisks standing_;
  std::vector<RoomSearch> searches_;  ///< one for each radius
};

/// The order in which a scene's disks are poured: `count` of each species, shuffled.
std::vector<std::uint32_t> pourOrder(const std::vector<SpeciesDefinition>& species, Random& random);

/// A species drawn by the shares. @pre one share at least is positive
std::uint32_t drawSpecies(const std::vector<SpeciesDefinition>& species, Random& random);

}  // namespace ratchet_sieve
