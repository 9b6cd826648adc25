#pragma once

#include <string>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// A configuration of RViz, its camera moved so that it shows all of a machine, whatever its size.
/// @param config text of a .rviz file whose current view is an orbit view
/// @throws std::invalid_argument where it is no such text
std::string fittedToScene(const std::string& config, const SceneDefinition& scene);

}  // namespace ratchet_sieve
