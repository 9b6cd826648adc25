#pragma once

#include <string>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// What the camera shows.
enum class RvizView
{
  MACHINE,  ///< all of it, with its bins and captions
  TEETH     ///< ten in the middle of the base, or all of a shorter one
};

/// A configuration of RViz, its camera moved so that it shows a machine of whatever size, and so the saved
/// views of ten teeth, in the middle of the base and at its left end, about which it tilts.
/// @param config text of a .rviz file whose current view is an orbit view
/// @throws std::invalid_argument where it is no such text
std::string fittedToScene(const std::string& config, const SceneDefinition& scene, RvizView view);

}  // namespace ratchet_sieve
