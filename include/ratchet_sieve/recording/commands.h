#pragma once

#include <cstdint>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// More disks at once are a slip, or no recording of this program: to find room for them takes seconds, which
/// grow with their square.
constexpr std::uint32_t MOST_POURED = 10000;

// How fast a base may follow its setpoints: from 0 to the largest that the node's limits may be in a tenth of
// a second at least, and in as long as a scene may last at most. Faster is no feeder, and has the disks
// looked at so often that a run may not end.
constexpr SlewRates SLOWEST_SLEW = {1.5e-9, 1e-5, 1e-9};
constexpr SlewRates FASTEST_SLEW = {15.0, 1e5, 10.0};

/// Gives a simulation a command at its present time; PAUSE and UNPAUSE change nothing in it.
/// Setpoints may be what a scene may say, slew rates what the node takes.
/// @throws std::invalid_argument where there is no such species or value; nothing has changed then
void apply(const CommandFrame& command, Simulation& simulation);

}  // namespace ratchet_sieve
