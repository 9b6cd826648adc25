#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// The input of a display at one instant, from the engine, from topics or from a bag. Kinds of frames that
/// were not recorded are empty.
struct Picture
{
  const SceneDefinition& scene;  ///< outlives this
  BaseFrame base;
  std::optional<BinFrame> bins;
  std::optional<ParticleFrame> particles;
  std::vector<SpeciesMeans> means = {};  ///< per species; empty if unknown
};

}  // namespace ratchet_sieve
