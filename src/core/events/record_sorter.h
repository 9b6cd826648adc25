#pragma once

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/observation.h"

namespace ratchet_sieve
{

/// Brings the collisions of disks that do not see each other, which come disk by disk, into the order of
/// time.
class RecordSorter
{
public:
  /// @param observer empty: nobody watches
  void setObserver(CollisionObserver observer) { observer_ = std::move(observer); }

  /// Whether records may be waiting.
  bool watched() const { return static_cast<bool>(observer_); }

  void take(const CollisionRecord& record) { waiting_.push_back(record); }

  /// Passes on all that it holds. @pre none that is still to come is earlier
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
