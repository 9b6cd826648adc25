#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "model/base_shape.h"

namespace ratchet_sieve
{

/// A contact within a step; stale if the flight of a disk has changed since it was found.
struct StepContact
{
  double time;
  std::uint32_t slot;
  std::uint32_t event_count;
  std::uint32_t partner;
  std::uint32_t partner_event_count;
  int shift;            ///< image of the partner, in widths to its right
  BaseFeature feature;  ///< none: the contact is with the partner

  /// Ties are broken by the smaller slots: the order is total.
  bool isBefore(const StepContact& other) const
  {
    return std::tie(time, slot, partner) < std::tie(other.time, other.slot, other.partner);
  }
};

/// The contacts of one step, earliest first: a calendar queue. There are about as many buckets as contacts,
/// so few share a bucket, regardless of the number of disks. Unlike in a heap, almost no branch depends on
/// comparisons of times.
class StepContacts
{
public:
  /// Begins a step. @pre start < end
  void begin(double start, double end, std::size_t disks)
  {
    start_ = start;
    heads_.assign(std::max(FEWEST_BUCKETS, disks / DISKS_PER_BUCKET), NONE);
    buckets_per_time_ = static_cast<double>(heads_.size()) / (end - start);
    present_ = 0;
    pool_.clear();
  }

  /// @pre contact.time is not earlier than the time of the last contact taken
  void push(const StepContact& contact)
  {
    const std::size_t bucket = bucketOf(contact.time);
    pool_.push_back({contact, heads_[bucket]});
    heads_[bucket] = static_cast<std::uint32_t>(pool_.size() - 1);
  }

  /// Removes the earliest. @return whether there was one
  bool pop(StepContact& contact)
  {
    while (heads_[present_] == NONE)
      if (++present_ == heads_.size())
        return present_ = heads_.size() - 1, false;
    std::uint32_t* earliest = &heads_[present_];
    for (std::uint32_t* link = &pool_[*earliest].next; *link != NONE; link = &pool_[*link].next)
      if (pool_[*link].contact.isBefore(pool_[*earliest].contact))
        earliest = link;
    const Entry& found = pool_[*earliest];
    contact = found.contact;
    *earliest = found.next;
    return true;
  }

private:
  static constexpr std::size_t FEWEST_BUCKETS = 256;
  static constexpr std::size_t DISKS_PER_BUCKET = 2;
  static constexpr std::uint32_t NONE = UINT32_MAX;

  struct Entry
  {
    StepContact contact;
    std::uint32_t next;  ///< in the bucket
  };

  std::size_t bucketOf(double time) const
  {
    const double bucket = std::max(0.0, (time - start_) * buckets_per_time_);
    return std::max(present_, std::min(heads_.size() - 1, static_cast<std::size_t>(bucket)));
  }

  double start_ = 0.0;
  double buckets_per_time_ = 0.0;
  std::vector<std::uint32_t> heads_;  ///< into the pool
  std::size_t present_ = 0;           ///< bucket of the present time
  std::vector<Entry> pool_;
};

}  // namespace ratchet_sieve
