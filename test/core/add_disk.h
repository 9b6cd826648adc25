#pragma once

#include <cstdint>

#include "state/system_state.h"

namespace ratchet_sieve::test
{

/// Adds a disk, of its species' own size unless it has a radius. @return its slot
inline std::uint32_t addDisk(SystemState& system, Disk disk)
{
  const SpeciesDefinition& species = system.scene().species[disk.species];
  if (disk.radius == 0.0)
    disk.radius = species.radius;
  return system.add(disk, propertiesOf(species, disk.radius));
}

}  // namespace ratchet_sieve::test
