#pragma once

#include <string>

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// The smallest disk radius that a scene may have.
struct FinestDisk
{
  double radius = 0.0;  ///< [m]
  std::string reason;   ///< the reason for the limit, for example "the base is 0.4 m wide"
};

/// Smaller disks would overlap by more than 1e-9 of their radius. Two causes: the rounding of positions as
/// large as the scene's, or the distance that the fastest disks move within the time resolution.
FinestDisk finestDisk(const SceneDefinition& scene);

}  // namespace ratchet_sieve
