#pragma once

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// Height of the walls of a walled scene above the foot line n = 0 [m]: base.wall_height if above 0.
/// Otherwise the top of the poured disks plus ten widths of the base. That is high enough to retain the disks
/// of a nearly upright base. It is low enough that disks thrown up by a turning base leave the machine.
/// Commands do not change the height.
double wallHeight(const SceneDefinition& scene);

/// The largest slew rate of the inclination at which a walled base throws no disks over its walls [rad/s], as
/// measured in docs/stability.md, "A walled base that turns". 0 without gravity, because nothing returns a
/// disk to the base.
double calmTurnRate(const SceneDefinition& scene);

}  // namespace ratchet_sieve
