#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/core/definition.h"
#include "scene_tree.h"

namespace ratchet_sieve
{

/// A number as a hand might write it: in full, short, or with an exponent; it reads back to the same.
std::string spelledNumber(double value);

/// The scene as YAML, some keys left out where they have their default, numbers spelled at random.
/// @param density instead of the counts, which it must split up to
SceneTree spelled(const SceneDefinition& scene, std::optional<double> density);

}  // namespace ratchet_sieve
