#pragma once

#include <limits>

#include "ratchet_sieve/core/definition.h"

/// How finely double precision resolves the times and positions of a scene.
namespace ratchet_sieve
{

/// As a fraction of a disk's radius; the accuracy goal of the engine.
constexpr double LARGEST_OVERLAP = 1e-9;

/// The rounding of a gap, as a fraction of the largest position: four resolutions of a double.
constexpr double GAP_ROUNDING = 4.0 * std::numeric_limits<double>::epsilon();

/// The largest of the pour speed, the speeds of the initial disks and the minimum rebound speed [m/s].
double startSpeed(const SceneDefinition& scene);

/// The time scale of the machine [s]. It is the shortest of: the drive's period, if it has an amplitude; the
/// free fall from a tooth's height; the time to cross a tooth at the largest of the pour speed, the initial
/// speeds and the minimum rebound speed. 1 s if nothing moves.
double timeScale(const SceneDefinition& scene);

/// Times are counted from the start of an epoch, so that their resolution does not degrade in a long run. A
/// power of two [s], so that no rounding occurs.
double epochLength(double time_scale);

/// The longest epoch for a base that moves at `speed` [m/s] and disks of `radius` [m]: within one step of the
/// time resolution, the base moves less than the overlap allowed for such a disk. A power of two [s];
/// infinity if the speed is 0.
double longestEpoch(double speed, double radius);

/// The same for disks that fall, but a twentieth of that overlap: flights, too, are counted from the start of
/// an epoch.
double longestFall(double gravity, double radius);

/// The largest distance from the origin at which positions are resolved finely enough for disks of this
/// radius [m].
double farthestPlace(double radius);

/// Times that differ by less than this are treated as equal [s].
double timeResolution(double epoch_length);

}  // namespace ratchet_sieve
