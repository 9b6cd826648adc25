#pragma once

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// Gives a simulation a command at its present time; PAUSE and UNPAUSE change nothing in it.
/// @throws std::invalid_argument where there is no such species or value; nothing has changed then
void apply(const CommandFrame& command, Simulation& simulation);

}  // namespace ratchet_sieve
