#pragma once

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// How high the walls of a walled scene stand over the foot line n = 0 [m]: base.wall_height; or if that is
/// 0, ten widths of the base over the poured disks: high enough to keep those of a base that stands nearly
/// upright, low enough that what a turning base throws flies over them. Commands do not change it.
double wallHeight(const SceneDefinition& scene);

/// How fast a walled base may turn without throwing disks over its walls [rad/s], as measured in
/// docs/stability.md, "A walled base that turns". 0 without gravity: nothing brings a disk back.
double calmTurnRate(const SceneDefinition& scene);

}  // namespace ratchet_sieve
