#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "search/overlap_search.h"
#include "search/size_levels.h"

namespace ratchet_sieve
{

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
