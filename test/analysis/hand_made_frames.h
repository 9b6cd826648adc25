#pragma once

#include <vector>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

inline DiskState diskAt(std::uint32_t id, std::uint32_t species, double displacement)
{
  DiskState disk;
  disk.id = id;
  disk.species = species;
  disk.displacement = displacement;
  return disk;
}

inline ParticleFrame particlesAt(double time, const std::vector<DiskState>& disks)
{
  ParticleFrame frame;
  frame.time = time;
  frame.disks = disks;
  return frame;
}

}  // namespace ratchet_sieve
