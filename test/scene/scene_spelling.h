#pragma once

#include <optional>

#include "ratchet_sieve/core/definition.h"
#include "scene_tree.h"

namespace ratchet_sieve
{

/// The scene as YAML, some keys left out where they have their default, numbers spelled at random.
/// @param density instead of the counts, which it must split up to
SceneTree spelled(const SceneDefinition& scene, std::optional<double> density);

}  // namespace ratchet_sieve
