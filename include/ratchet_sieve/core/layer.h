#pragma once

#include <cstddef>
#include <string>

#include "ratchet_sieve/core/definition.h"

/// The number of disks in a scene, and the height of their layer.
namespace ratchet_sieve
{

/// The number of disks poured or placed at the start.
std::size_t disksAtStart(const SceneDefinition& scene);

/// Whether the machine runs empty: disks leave over open ends, and there is no feed.
bool empties(const SceneDefinition& scene);

/// The largest diameter that a disk of any species can have, including species with no disks [m]; 0 without
/// species.
double largestDiameter(const SceneDefinition& scene);

/// The width over which the disks stand after the pour: its stretch and one largest diameter, at most the
/// base's width [m].
double pouredWidth(const SceneDefinition& scene);

/// The smallest radius that a disk of any species can have, including species with no disks [m]. @pre there
/// is a species
double smallestRadius(const SceneDefinition& scene);

/// The height of the settled layer of the disks present at the start [m]; 0 if disks do not collide with each
/// other.
double settledLayer(const SceneDefinition& scene);

/// The speed at which the feed raises the settled layer while no disk leaves [m/s].
double feedGrowth(const SceneDefinition& scene);

/// One line for the user, printed before the pour: number of disks, layer height, memory.
std::string sizeText(const SceneDefinition& scene);

}  // namespace ratchet_sieve
