#pragma once

#include <cstdint>

namespace ratchet_sieve
{

/// Goes up with every change by which a scene and a seed give another state or another summary than before,
/// be it in the last bit. Sweeps keep results by it: those of one version are taken for one another,
/// whichever package they are of. A run is resumed by the same version alone. PhysicsVersion in test/sweep
/// fails until it is raised.
constexpr std::int64_t PHYSICS_VERSION = 1;

}  // namespace ratchet_sieve
