#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// What of a legal scene can hardly be meant, such as lengths in mm where metres are asked for: a line for
/// each, with the key, its value, the figure that makes it implausible and, where one is near, what was
/// probably meant. Empty for a scene that could be built.
///
/// Figures are ratios within the scene where there are such, so that a machine of another size is as
/// plausible.
/// @param scene as it was read: every count is set
std::vector<std::string> implausibilities(const SceneDefinition& scene);

}  // namespace ratchet_sieve
