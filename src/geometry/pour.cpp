#include "ratchet_sieve/geometry/pour.h"

#include <algorithm>

namespace ratchet_sieve
{

Pour::Pour(const PourBed& bed, double largest_diameter, bool see_each_other)
    : bed_(bed),
      see_each_other_(see_each_other),
      standing_(bed.width, bed.periodic, largest_diameter, memory_)
{
}

PlacedDisk Pour::place(double radius, double share)
{
  PlacedDisk disk;
  disk.radius = radius;
  const double margin = bed_.periodic ? 0.0 : radius;
  // A stretch beside an end is cut to where the disk has room.
  const double left = std::clamp(bed_.from, margin, std::max(margin, bed_.width - margin));
  const double right = std::max(bed_.width - bed_.to, margin);
  disk.s = left + share * std::max(0.0, bed_.width - (left + right));
  const double lowest = bed_.lowest + radius;
  disk.n = see_each_other_ ? searchFor(radius).lowestFree(disk.s, radius, lowest, standing_) : lowest;
  occupy(disk);
  return disk;
}

RoomSearch& Pour::searchFor(double radius)
{
  for (RoomSearch& search : searches_)
    if (search.serves(radius))
      return search;
  searches_.emplace_back(bed_.lowest + radius, radius, standing_.columnWidth(), memory_);
  return searches_.back();
}

}  // namespace ratchet_sieve
