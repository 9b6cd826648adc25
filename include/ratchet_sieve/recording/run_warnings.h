#pragma once

#include <cstdint>
#include <string>

#include "ratchet_sieve/core/simulation.h"

/// Warnings of one line about a run; empty if there is nothing to warn of.
namespace ratchet_sieve
{

/// The figures of chokeOf() in one line.
std::string chokeText(const Simulation& simulation);

/// The figures of an implausibly large energy of a disk in one line.
std::string energyText(const Simulation& simulation);

/// The number of disks that have left a walled machine over its walls; 0 for other machines.
std::uint64_t disksOverWalls(const Simulation& simulation);

/// A warning of one line: the number of disks that went over the walls, the height of the walls and the
/// remedy; empty if there are none.
std::string overWallsText(const Simulation& simulation);

/// A warning of one line for a walled base whose slew rate exceeds calmTurnRate(): by how much, and the
/// remedy; empty otherwise.
/// @param slew_rate of the inclination [rad/s]
std::string fastTurnText(const SceneDefinition& scene, double slew_rate);

}  // namespace ratchet_sieve
