#pragma once

#include <cstdint>

#include "state/machine.h"

namespace ratchet_sieve::test
{

/// Adds a disk, of its species' own size unless it has a radius, to a Machine or a MachineState.
/// @return its slot
template <typename AnyMachine>
std::uint32_t addDisk(AnyMachine& machine, const SceneDefinition& scene, Disk disk)
{
  const SpeciesDefinition& species = scene.species[disk.species];
  if (disk.radius == 0.0)
    disk.radius = species.radius;
  return machine.add(disk, grainOf(species, disk.radius));
}

inline std::uint32_t addDisk(SystemState& machine, const Disk& disk)
{
  return addDisk(machine, machine.scene(), disk);
}

inline std::uint32_t addDisk(Machine& machine, const Disk& disk)
{
  return addDisk(machine, machine.state().scene(), disk);
}

}  // namespace ratchet_sieve::test
