#pragma once

#include <cstdint>
#include <vector>

#include "model/random.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Pours disks onto a stretch of the base at `time` (local to the epoch), one of each species in the list,
/// beside and above the existing disks.
/// @param observer see Simulation
void pourDisks(SystemState& system, const std::vector<std::uint32_t>& species, const Stretch& stretch,
               double time, Random& random, const PourObserver& observer = {});

/// Adds the disks of the scene's `initial` to an empty machine.
/// @throws std::invalid_argument if they overlap each other or the base, or are outside; the message names
/// them
void placeInitialDisks(SystemState& system, double time);

}  // namespace ratchet_sieve
