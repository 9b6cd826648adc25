#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "events/event_queue.h"

namespace ratchet_sieve
{

/// An event queue of some of the slots. The order is that of one EventQueue of all.
class SlotQueue
{
public:
  static constexpr std::uint32_t NONE = UINT32_MAX;

  /// @param places per slot: its place in the queue that has it, NONE if none has; outlives this
  explicit SlotQueue(std::vector<std::uint32_t>& places) : places_(&places) { queue_.resize(0); }

  /// Adds the slot if it is not there.
  void update(std::uint32_t slot, double time)
  {
    if ((*places_)[slot] == NONE)
      add(slot);
    queue_.update((*places_)[slot], time);
  }

  /// @pre the slot is there
  void erase(std::uint32_t slot)
  {
    std::uint32_t& place = (*places_)[slot];
    queue_.update(place, EventQueue::NEVER);
    free_.push_back(place);
    slots_[place] = NONE;
    place = NONE;
  }

  double topTime() const { return queue_.topTime(); }

  /// The slot with the earliest event; the smallest of several. @pre topTime() is finite
  std::uint32_t top()
  {
    if (!queue_.isTied())
      return slots_[queue_.top()];
    queue_.upTo(queue_.topTime(), tied_);
    std::uint32_t first = NONE;
    for (const std::uint32_t place : tied_)
      first = std::min(first, slots_[place]);
    return first;
  }

  /// Calls `visit` with each slot, and removes it.
  template <typename Visit>
  void takeAll(Visit&& visit)
  {
    for (std::uint32_t place = 0; place < slots_.size(); ++place)
    {
      const std::uint32_t slot = slots_[place];
      if (slot == NONE)
        continue;
      queue_.update(place, EventQueue::NEVER);
      (*places_)[slot] = NONE;
      visit(slot);
    }
    slots_.clear();
    free_.clear();
  }

private:
  void add(std::uint32_t slot)
  {
    std::uint32_t& place = (*places_)[slot];
    if (free_.empty())
    {
      place = static_cast<std::uint32_t>(slots_.size());
      slots_.push_back(slot);
      if (slots_.size() > capacity_)
      {
        capacity_ = 2 * slots_.size();
        queue_.resize(capacity_);
      }
      return;
    }
    place = free_.back();
    free_.pop_back();
    slots_[place] = slot;
  }

  EventQueue queue_;                    ///< by place
  std::vector<std::uint32_t> slots_;    ///< by place; NONE: free
  std::vector<std::uint32_t> free_;     ///< places
  std::vector<std::uint32_t>* places_;  ///< by slot
  std::size_t capacity_ = 0;
  std::vector<std::uint32_t> tied_;  ///< places
};

}  // namespace ratchet_sieve
