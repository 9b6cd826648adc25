#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// Implausible values of a valid scene, such as lengths in mm instead of m: a line for each, with the key,
/// its value, the reason and, if there is one, a suggested value. Empty for a scene that could be built.
///
/// Where possible, limits are ratios within the scene, so that they hold for machines of any size.
/// @param scene as it was read: every count is set
std::vector<std::string> implausibilities(const SceneDefinition& scene);

}  // namespace ratchet_sieve
