#pragma once

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

/// What a frame has to be for an analysis to take it: a bag may hold anything.
namespace ratchet_sieve
{

/// @throws AnalysisError: a number that is not finite, a count or a place beyond any machine, or species
/// that are not the scene's
template <typename Frame>
void requireSound(const Frame& frame, const SceneDefinition& scene);

}  // namespace ratchet_sieve
