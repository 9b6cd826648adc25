#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// Leaves of an array only what stands at these places, one behind the other. @param places rising
template <typename T>
void keepPlaces(std::vector<T>& array, const std::vector<std::uint32_t>& places)
{
  for (std::size_t k = 0; k < places.size(); ++k)
    array[k] = array[places[k]];
  array.resize(places.size());
}

/// Which disk stands at which place of the machine's arrays. Every disk that ever enters gets the next
/// number; as long as no place was given up, that is its place.
class DiskNumbers
{
public:
  std::uint32_t of(std::uint32_t place) const { return given_up_ ? numbers_[place] : place; }

  void added()
  {
    if (given_up_)
      numbers_.push_back(next_);
    ++next_;
  }

  /// The disks at these places stand one behind the other from now on, the others are gone.
  void keep(const std::vector<std::uint32_t>& places)
  {
    std::vector<std::uint32_t> kept;
    kept.reserve(places.size());
    for (const std::uint32_t place : places)
      kept.push_back(of(place));
    numbers_ = std::move(kept);
    given_up_ = true;
  }

  void archive(StateArchive& state) { state(given_up_, next_, numbers_); }

  /// Whether it can be that of so many places.
  bool fits(std::size_t places) const { return given_up_ ? numbers_.size() == places : next_ == places; }

private:
  bool given_up_ = false;
  std::uint32_t next_ = 0;
  std::vector<std::uint32_t> numbers_;  ///< by place, once places were given up
};

}  // namespace ratchet_sieve
