#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/random.h"
#include "ratchet_sieve/core/definition.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// The order in which a scene's disks are poured: `count` of each species, shuffled.
std::vector<std::uint32_t> pourOrder(const std::vector<SpeciesDefinition>& species, Random& random);

/// A random species, with probabilities proportional to the shares. @pre at least one share is positive
std::uint32_t drawSpecies(const std::vector<SpeciesDefinition>& species, Random& random);

/// Pours disks onto a stretch of the base at `time` (local to the epoch), one of each species in the list,
/// beside and above the existing disks.
/// @param observer see Simulation
/// @param own radius and mass of these disks; null: of the sizes of their species
void pourDisks(SystemState& system, const std::vector<std::uint32_t>& species, const Stretch& stretch,
               double time, Random& random, const PourObserver& observer = {}, const FedDisk* own = nullptr);

/// Adds the disks of the scene's `initial` to an empty machine.
/// @throws std::invalid_argument if they overlap each other or the base, or are outside; the message names
/// them
void placeInitialDisks(SystemState& system, double time);

/// The result of a check of all disks at one time.
struct Audit
{
  double largest_overlap = 0.0;    ///< between two disks, or a disk and the base [m]
  std::size_t behind_surface = 0;  ///< disks with their centre below the base's surface: must be 0
};

/// Measures the distances of every disk to the base and to its neighbours, independently of the engine's
/// predictions. @param time local to the epoch
Audit audit(const SystemState& system, double time);

}  // namespace ratchet_sieve
