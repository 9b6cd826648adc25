#pragma once

#include <memory_resource>
#include <vector>

#include "ratchet_sieve/geometry/room_search.h"
#include "ratchet_sieve/geometry/standing_disks.h"

namespace ratchet_sieve
{

/// Where disks are poured: onto a stretch of a base, for their centres [m].
struct PourBed
{
  double width;  ///< of the base
  bool periodic;
  double from;    ///< s of the stretch's left end
  double to;      ///< s of its right end; beyond the base: the base's
  double lowest;  ///< height of the lowest undersides
};

/// Finds positions for new disks: each at a random place on a stretch of the base, as low as the drop height
/// and the existing disks allow.
class Pour
{
public:
  /// @param see_each_other false if disks do not collide: they may then overlap
  Pour(const PourBed& bed, double largest_diameter, bool see_each_other);

  /// Adds an existing disk.
  void occupy(const PlacedDisk& disk)
  {
    if (see_each_other_)
      standing_.add(disk);
  }

  /// Places one more disk, and adds it. @param share of the stretch at its left, uniformly random in [0, 1)
  PlacedDisk place(double radius, double share);

private:
  RoomSearch& searchFor(double radius);

  PourBed bed_;
  bool see_each_other_;
  /// For what finds room: many small pieces, given back as a few large ones. Freed one by one they would stay
  /// with the heap, which has no use for them while a run goes on.
  std::pmr::monotonic_buffer_resource blocks_;
  std::pmr::unsynchronized_pool_resource memory_{&blocks_};
  StandingDisks standing_;
  std::vector<RoomSearch> searches_;  ///< one per radius, or class of radii
};

}  // namespace ratchet_sieve
