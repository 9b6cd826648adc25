#pragma once

#include <cstdint>
#include <string>

#include "ratchet_sieve/core/simulation.h"

/// Warnings of one line about a run; empty if there is nothing to warn of.
namespace ratchet_sieve
{

/// One line of figures if the feed chokes the base at time(): fewer than half as many disks have left as were
/// fed, and the others have raised the layer, at rest and over the whole base, by more than four of the
/// largest diameters. Empty otherwise, and for disks that do not collide with each other. A base that fills
/// up to the layer that it conveys is thinner than that.
std::string chokeText(const Simulation& simulation);

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
