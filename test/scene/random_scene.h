#pragma once

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// Any legal scene that is cheap to run. Sizes, masses, times and coefficients go over the whole of their
/// ranges; what costs time is bounded by these ratios, w the width of a tooth:
/// - at most some 30 disks, poured, placed or fed on;
/// - radii, tooth height and amplitude up to 20, 20 and 10 w: a search looks at the teeth within reach;
/// - a drop of up to 100 w, and a duration of that fall and up to 10 times what the fastest
///   movement needs for a tooth;
/// - a rebound floor that lifts a resting disk for 1/100 of the machine's time scale from the base, or none
///   where nothing comes to rest;
/// - masses within 10^4 of each other: a light disk between two heavy ones bounces as often as the root of
/// it;
/// - spins whose surface is up to 10 times as fast as the disk.
/// What double precision cannot tell apart is bounded by these:
/// - radii of at least 1/1000 w, and of at least 4e-6 of the base's width;
/// - speeds of up to 20,000 of the smallest radii in the machine's time scale.
SceneDefinition drawnRunnableScene();

}  // namespace ratchet_sieve
