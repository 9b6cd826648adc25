#pragma once

#include <cstddef>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// The disks of a scene: their number, their sizes, their feed and the height of their layer.

/// The number of disks poured or placed at the start.
std::size_t disksAtStart(const SceneDefinition& scene);

/// Whether the machine runs empty: disks leave over open ends, and there is no feed.
bool empties(const SceneDefinition& scene);

/// The largest diameter that a disk of any species can have, including species with no disks, and those of
/// feed.disks [m]; 0 without species.
double largestDiameter(const SceneDefinition& scene);

/// The width over which the disks stand after the pour: its stretch and one largest diameter, at most the
/// base's width [m].
double pouredWidth(const SceneDefinition& scene);

/// The smallest radius that a disk of any species can have, including species with no disks, and those of
/// feed.disks [m]. @pre there is a species
double smallestRadius(const SceneDefinition& scene);

/// The height of the settled layer of the disks present at the start [m]; 0 if disks do not collide with each
/// other.
double settledLayer(const SceneDefinition& scene);

/// The mean number of disks fed per second, of a list until its last disk [1/s].
double feedRate(const SceneDefinition& scene);

/// The speed at which the feed raises the settled layer while no disk leaves [m/s].
double feedGrowth(const SceneDefinition& scene);

/// Height of the walls of a walled scene above the foot line n = 0 [m]: base.wall_height if above 0.
/// Otherwise the top of the poured disks plus ten widths of the base. That is high enough to retain the disks
/// of a nearly upright base. It is low enough that disks thrown up by a turning base leave the machine.
/// Commands do not change the height.
double wallHeight(const SceneDefinition& scene);

/// The largest slew rate of the inclination at which a walled base throws no disks over its walls [rad/s], as
/// measured in docs/stability.md, "A walled base that turns". 0 without gravity, because nothing returns a
/// disk to the base.
double calmTurnRate(const SceneDefinition& scene);

}  // namespace ratchet_sieve
