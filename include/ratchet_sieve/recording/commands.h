#pragma once

#include <cstdint>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// More disks at once are a slip, or no recording of this program: to find room for them takes seconds, which
/// grow with their square.
constexpr std::uint32_t MOST_POURED = 10000;

/// Gives a simulation a command at its present time; PAUSE and UNPAUSE change nothing in it.
/// @throws std::invalid_argument where there is no such species or value; nothing has changed then
void apply(const CommandFrame& command, Simulation& simulation);

}  // namespace ratchet_sieve
