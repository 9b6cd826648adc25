#pragma once

#include <cstddef>

namespace ratchet_sieve
{

/// Prefetches all cache lines of an object. Affects only the speed.
template <typename T>
void prefetch(const T& object)
{
  constexpr std::size_t LINE = 64;
  const char* const bytes = reinterpret_cast<const char*>(&object);
  for (std::size_t offset = 0; offset < sizeof object; offset += LINE)
    __builtin_prefetch(bytes + offset);
  // Without its own alignment, an object may extend into one more line.
  if (alignof(T) < LINE)
    __builtin_prefetch(bytes + sizeof object - 1);
}

}  // namespace ratchet_sieve
