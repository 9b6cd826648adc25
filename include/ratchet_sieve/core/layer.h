#pragma once

#include <cstddef>
#include <string>

#include "ratchet_sieve/core/definition.h"

/// How many disks a scene has, and how much room they take.
namespace ratchet_sieve
{

/// That are poured or placed at the start.
std::size_t disksAtStart(const SceneDefinition& scene);

/// The height to which the disks of the start fill the base where they lie in a heap [m]; 0 where they do not
/// see each other.
double settledLayer(const SceneDefinition& scene);

/// By how much the feed raises such a layer, as long as nothing leaves it [m/s].
double feedGrowth(const SceneDefinition& scene);

/// One line for a human, before the disks are poured: how many, how high they will lie, how much memory they
/// take.
std::string sizeText(const SceneDefinition& scene);

}  // namespace ratchet_sieve
