#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/processor.h"

namespace ratchet_sieve
{

/// An event queue with one event time per disk: a complete tournament tree as in Marin & Cordero (Comput.
/// Phys. Commun. 92, 214 (1995)), but with sixteen children per node instead of two: a node fills two cache
/// lines, and its minimum is found without branches. Ties are broken by the smaller slot, so the order of
/// events is total.
class EventQueue
{
public:
  static constexpr double NEVER = std::numeric_limits<double>::infinity();

  /// Allocates slots below `count`; new ones have no event.
  void resize(std::size_t count)
  {
    if (rounds_.empty())
      rounds_.emplace_back();
    rounds_.resize(1);
    rounds_[0].resize(std::max(groupsFor(count), rounds_[0].size()));
    while (rounds_.back().size() > 1)
      rounds_.emplace_back(groupsFor(rounds_.back().size()));
    playAll();
  }

  void update(std::uint32_t slot, double time)
  {
    std::size_t child = slot;
    for (std::size_t round = 0;; ++round)
    {
      Group& group = rounds_[round][child / GROUP];
      group.times[child % GROUP] = time;
      time = group.earliest();
      child /= GROUP;
      if (round + 1 == rounds_.size())
        break;
      // If the minimum of the group stays the same, the nodes above stay the same.
      if (rounds_[round + 1][child / GROUP].times[child % GROUP] == time)
        return;
    }
    top_time_ = time;
  }

  /// The slot with the earliest event. @pre resize() was called
  std::uint32_t top() const
  {
    std::size_t child = 0;
    for (auto round = rounds_.rbegin(); round != rounds_.rend(); ++round)
      child = child * GROUP + (*round)[child].find(top_time_);
    return static_cast<std::uint32_t>(child);
  }

  double topTime() const { return top_time_; }

  /// Whether another slot's event is at the same time as that of top().
  bool isTied() const
  {
    std::size_t child = 0;
    for (auto round = rounds_.rbegin(); round != rounds_.rend(); ++round)
    {
      const unsigned found = (*round)[child].upTo(top_time_);
      if ((found & (found - 1)) != 0)
        return true;
      child = child * GROUP + static_cast<std::size_t>(__builtin_ctz(found));
    }
    return false;
  }

  /// The slots whose events are not later than `time`, in increasing order. @param slots are replaced
  void upTo(double time, std::vector<std::uint32_t>& slots) const
  {
    slots.assign(1, 0);
    for (std::size_t round = rounds_.size(); round-- > 0;)
    {
      const std::size_t groups = slots.size();
      for (std::size_t g = 0; g < groups; ++g)
      {
        const std::uint32_t group = slots[g];
        for (unsigned found = rounds_[round][group].upTo(time); found != 0; found &= found - 1)
        {
          const auto child = static_cast<std::uint32_t>(group * GROUP + __builtin_ctz(found));
          slots.push_back(child);
          if (round > 0)
            prefetch(rounds_[round - 1][child]);
        }
      }
      slots.erase(slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(groups));
    }
  }

  /// Subtracts `length` from every time.
  void rebase(double length)
  {
    for (Round& round : rounds_)
      for (Group& group : round)
        for (double& time : group.times)
          time -= length;
    top_time_ -= length;
  }

private:
  static constexpr std::size_t GROUP = 16;

  struct alignas(64) Group
  {
    std::array<double, GROUP> times;

    Group() { times.fill(NEVER); }

    double earliest() const { return smallest(times.data()); }

    /// The index of the first that is not later. @pre there is one
    std::size_t find(double time) const { return static_cast<std::size_t>(__builtin_ctz(upTo(time))); }

    /// One bit per time that is not later.
    unsigned upTo(double time) const { return whichUpTo(times.data(), time); }
  };
  using Round = std::vector<Group>;

  static std::size_t groupsFor(std::size_t count)
  {
    return std::max<std::size_t>(1, (count + GROUP - 1) / GROUP);
  }

  void playAll()
  {
    for (std::size_t r = 0; r + 1 < rounds_.size(); ++r)
      for (std::size_t g = 0; g < rounds_[r].size(); ++g)
        rounds_[r + 1][g / GROUP].times[g % GROUP] = rounds_[r][g].earliest();
    top_time_ = rounds_.back()[0].earliest();
  }

  std::vector<Round>
      rounds_;  ///< the first is over disks, each further one over the groups of the one before
  double top_time_ = NEVER;
};

}  // namespace ratchet_sieve
