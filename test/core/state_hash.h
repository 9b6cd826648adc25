#pragma once

#include <cstdint>
#include <cstring>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve::test
{

/// FNV-1a over the bits of every disk's state.
inline std::uint64_t stateHash(const Simulation& simulation)
{
  std::uint64_t hash = 14695981039346656037ull;
  const auto take = [&hash](double value)
  {
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    for (int byte = 0; byte < 8; ++byte)
      hash = (hash ^ ((bits >> (8 * byte)) & 0xff)) * 1099511628211ull;
  };
  for (const DiskState& disk : simulation.disks())
    for (const double value : {static_cast<double>(disk.id), static_cast<double>(disk.species), disk.x,
                               disk.y, disk.angle, disk.vx, disk.vy, disk.spin, disk.displacement})
      take(value);
  return hash;
}

}  // namespace ratchet_sieve::test
