#pragma once

#include <cstdint>

#include "state/contact_execution.h"
#include "state/system_state.h"

namespace ratchet_sieve::test
{

/// A system and the execution of its contacts, for tests that bring their own loop or none.
struct Bench
{
  explicit Bench(const SceneDefinition& scene) : state(scene), execution(state) {}

  SystemState state;
  ContactExecution execution;
};

/// Adds a disk, of its species' own size unless it has a radius. @return its slot
inline std::uint32_t addDisk(SystemState& system, Disk disk, double time = 0.0)
{
  const SpeciesDefinition& species = system.scene().species[disk.species];
  if (disk.radius == 0.0)
    disk.radius = species.radius;
  return system.add(disk, propertiesOf(species, disk.radius), time);
}

}  // namespace ratchet_sieve::test
