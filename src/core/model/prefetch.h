#pragma once

#include <cstddef>

namespace ratchet_sieve
{

/// Asks the processor to bring an object into its caches, every line of it, while it goes on with something
/// else. Nothing but time depends on it.
template <typename T>
void prefetch(const T& object)
{
  constexpr std::size_t LINE = 64;
  const char* const bytes = reinterpret_cast<const char*>(&object);
  for (std::size_t offset = 0; offset < sizeof object; offset += LINE)
    __builtin_prefetch(bytes + offset);
  // Without an alignment of its own it may reach into one line more.
  if (alignof(T) < LINE)
    __builtin_prefetch(bytes + sizeof object - 1);
}

}  // namespace ratchet_sieve
