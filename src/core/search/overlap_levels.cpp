#include "search/overlap_levels.h"

namespace ratchet_sieve
{

void OverlapLevels::sort()
{
  if (placed_.size() > 2 * chosen_for_ || searches_.empty())
    chooseLevels();
  for (OverlapSearch& search : searches_)
    search.begin(level_of_.size());
  for (const Placed& disk : placed_)
  {
    level_of_[disk.slot] = levels_.of(disk.radius);
    searches_[level_of_[disk.slot]].place(disk.slot, disk.s, disk.n, disk.radius);
  }
  for (OverlapSearch& search : searches_)
    search.sort();
}

void OverlapLevels::chooseLevels()
{
  std::vector<double> radii;
  for (const Placed& disk : placed_)
    radii.push_back(disk.radius);
  levels_ = cheapestLevels(radii, largest_diameter_);
  chosen_for_ = placed_.size();
  searches_.clear();
  for (const double diameter : levels_.diameters)
    searches_.emplace_back(width_, diameter, periodic_);
}

}  // namespace ratchet_sieve
