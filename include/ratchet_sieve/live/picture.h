#pragma once

#include <optional>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// What a display shows of a run at one instant, wherever the frames come from: the engine, topics, a bag.
/// Kinds of frames that nobody has recorded are left out.
struct Picture
{
  const SceneDefinition& scene;  ///< outlives this
  BaseFrame base;
  std::optional<BinFrame> bins;
  std::optional<ParticleFrame> particles;
  std::vector<SpeciesMeans> means = {};  ///< per species; empty: not known
};

}  // namespace ratchet_sieve
