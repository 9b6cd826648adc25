#pragma once

#include <cstdint>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// How many disks have left a walled machine over its walls; 0 for other machines.
std::uint64_t disksOverWalls(const Simulation& simulation);

/// One line that says how many disks went over the walls, how high those are and what helps; empty where none
/// did.
std::string overWallsText(const Simulation& simulation);

/// One line that says, for a walled base that may turn faster than it can without throwing its disks over the
/// walls (calmTurnRate()), by how much and what helps; empty for others.
/// @param slew_rate of the inclination [rad/s]
std::string fastTurnText(const SceneDefinition& scene, double slew_rate);

}  // namespace ratchet_sieve
