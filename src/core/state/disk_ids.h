#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Keeps only the elements at these slots of an array, which become consecutive. @param slots in increasing
/// order
template <typename Array>
void keepSlots(Array& array, const std::vector<std::uint32_t>& slots)
{
  for (std::size_t k = 0; k < slots.size(); ++k)
    array[k] = array[slots[k]];
  array.resize(slots.size());
}

/// The ids of the disks. A disk's *id* is its public number: every new disk gets the next. Its *slot* is its
/// index in the arrays. Both are equal until disks that have left are removed by compaction, which moves the
/// others to smaller slots.
class DiskIds
{
public:
  std::uint32_t of(std::uint32_t slot) const { return compacted_ ? ids_[slot] : slot; }

  void added()
  {
    if (compacted_)
      ids_.push_back(next_);
    ++next_;
  }

  /// Keeps the disks at these slots, which become consecutive, and forgets the others.
  void keep(const std::vector<std::uint32_t>& slots)
  {
    std::vector<std::uint32_t> kept;
    kept.reserve(slots.size());
    for (const std::uint32_t slot : slots)
      kept.push_back(of(slot));
    ids_ = std::move(kept);
    compacted_ = true;
  }

  void archive(StateArchive& state) { state(compacted_, next_, ids_); }

  /// Whether it can belong to this number of slots.
  bool fits(std::size_t slots) const { return compacted_ ? ids_.size() == slots : next_ == slots; }

private:
  bool compacted_ = false;
  std::uint32_t next_ = 0;
  std::vector<std::uint32_t> ids_;  ///< by slot, once compacted
};

}  // namespace ratchet_sieve
