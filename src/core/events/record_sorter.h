#pragma once

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/observation.h"

namespace ratchet_sieve
{

/// Sorts the collisions of independent disks, which are simulated disk by disk, into the order of time.
class RecordSorter
{
public:
  /// @param observer an empty function removes it
  void setObserver(CollisionObserver observer) { observer_ = std::move(observer); }

  /// Whether records are collected.
  bool watched() const { return static_cast<bool>(observer_); }

  void take(const CollisionRecord& record) { waiting_.push_back(record); }

  /// Passes on all records. @pre no later record has an earlier time
  void flush()
  {
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [](const CollisionRecord& a, const CollisionRecord& b)
                     { return std::tie(a.time, a.i) < std::tie(b.time, b.i); });
    for (const CollisionRecord& record : waiting_)
      observer_(record);
    waiting_.clear();
  }

private:
  CollisionObserver observer_;
  std::vector<CollisionRecord> waiting_;
};

}  // namespace ratchet_sieve
