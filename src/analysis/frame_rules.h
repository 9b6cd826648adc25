#pragma once

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

/// The conditions that a frame must meet for the analysis, because a bag may contain anything.
namespace ratchet_sieve
{

/// @throws AnalysisError for a number that is not finite, an impossible count or position, or species that
/// are not in the scene
template <typename Frame>
void requireSound(const Frame& frame, const SceneDefinition& scene);

}  // namespace ratchet_sieve
