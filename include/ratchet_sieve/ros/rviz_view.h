#pragma once

#include <string>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// The part that the camera shows.
enum class RvizView
{
  MACHINE,  ///< the whole machine with bins and captions
  TEETH     ///< ten teeth in the middle of the base, or all of a shorter base
};

/// Adapts an RViz configuration to the size of a machine: moves the camera, and the saved views of ten teeth
/// in the middle and at the left end of the base, about which the base tilts.
/// @param config text of a .rviz file whose current view is an orbit view
/// @throws std::invalid_argument if the text is not of that kind
std::string fittedToScene(const std::string& config, const SceneDefinition& scene, RvizView view);

}  // namespace ratchet_sieve
