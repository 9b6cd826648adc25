#pragma once

#include <cstdint>
#include <string_view>

namespace ratchet_sieve
{

/// FNV-1a, 64 bits (draft-eastlake-fnv).
inline std::uint64_t fnv1a(std::string_view bytes)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes)
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  return hash;
}

}  // namespace ratchet_sieve
