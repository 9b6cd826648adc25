#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Leaves of an array only what stands at these slots, one behind the other. @param slots rising
template <typename T>
void keepSlots(std::vector<T>& array, const std::vector<std::uint32_t>& slots)
{
  for (std::size_t k = 0; k < slots.size(); ++k)
    array[k] = array[slots[k]];
  array.resize(slots.size());
}

/// A disk has two numbers. Its *id* is what it is known by outside: every disk that ever enters gets the
/// next. Its *slot* is where it stands in the arrays: the same as its id until the disks that left are
/// compacted away, which moves the others up.
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

  /// The disks at these slots stand one behind the other from now on, the others are gone.
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

  /// Whether it can be that of so many slots.
  bool fits(std::size_t slots) const { return compacted_ ? ids_.size() == slots : next_ == slots; }

private:
  bool compacted_ = false;
  std::uint32_t next_ = 0;
  std::vector<std::uint32_t> ids_;  ///< by slot, once compacted
};

}  // namespace ratchet_sieve
