#include "state/pour.h"

#include <algorithm>
#include <utility>

namespace ratchet_sieve
{

Pour::Pour(const BaseDefinition& base, Boundary boundary, const Stretch& stretch, double drop_height,
           double largest_diameter, bool see_each_other)
    : stretch_(stretch),
      width_(base.width()),
      lowest_underside_(base.highest() + base.amplitude + drop_height),
      periodic_(boundary == Boundary::PERIODIC),
      see_each_other_(see_each_other),
      standing_(width_, periodic_, largest_diameter, memory_)
{
}

void Pour::occupy(const PlacedDisk& disk)
{
  if (see_each_other_)
    standing_.add(disk);
}

PlacedDisk Pour::place(double radius, Random& random)
{
  PlacedDisk disk;
  disk.radius = radius;
  const double margin = periodic_ ? 0.0 : radius;
  // A stretch beside an end is cut to where the disk has room.
  const double left = std::clamp(stretch_.from, margin, std::max(margin, width_ - margin));
  const double right = std::max(width_ - stretch_.to, margin);
  disk.s = left + random.uniform() * std::max(0.0, width_ - (left + right));
  const double lowest = lowest_underside_ + radius;
  disk.n = see_each_other_ ? searchFor(radius).lowestFree(disk.s, radius, lowest, standing_) : lowest;
  occupy(disk);
  return disk;
}

RoomSearch& Pour::searchFor(double radius)
{
  for (RoomSearch& search : searches_)
    if (search.serves(radius))
      return search;
  searches_.emplace_back(lowest_underside_ + radius, radius, standing_.columnWidth(), memory_);
  return searches_.back();
}

std::vector<std::uint32_t> pourOrder(const std::vector<SpeciesDefinition>& species, Random& random)
{
  std::vector<std::uint32_t> order;
  for (std::uint32_t s = 0; s < species.size(); ++s)
    order.insert(order.end(), static_cast<std::size_t>(species[s].count), s);
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

std::uint32_t drawSpecies(const std::vector<SpeciesDefinition>& species, Random& random)
{
  double total = 0.0;
  for (const auto& s : species)
    total += s.share;
  double left = random.uniform() * total;
  for (std::uint32_t s = 0; s + 1 < species.size(); ++s)
  {
    left -= species[s].share;
    if (left < 0.0)
      return s;
  }
  return static_cast<std::uint32_t>(species.size() - 1);
}

}  // namespace ratchet_sieve
