#pragma once

#include <string>

#include "ratchet_sieve/core/definition.h"

/// How finely double precision holds the times and positions of a scene.
namespace ratchet_sieve
{

/// The shortest of the drive's period (where it has an amplitude), of a fall over a tooth and of the way over
/// a tooth at the speed of the pour, of an initial disk or of the rebound floor [s]: what is short against it
/// is short for this machine. 1 s where nothing moves.
double timeScale(const SceneDefinition& scene);

/// Times are counted from the start of an epoch, so that they are as fine at the end of a long run as at
/// its start. A power of two [s], so that nothing rounds.
double epochLength(double time_scale);

/// The longest epoch in whose finest step in time a base that moves at `speed` [m/s] comes no nearer to a
/// disk of this radius [m] than it may overlap it. A power of two [s]; infinity where the speed is 0.
double longestEpoch(double speed, double radius);

/// How far from the origin positions are still held finely enough for disks of this radius [m].
double farthestPlace(double radius);

/// Times closer than this count as equal [s].
double timeResolution(double epoch_length);

/// The smallest disks that a scene may have.
struct FinestDisk
{
  double radius = 0.0;  ///< [m]
  std::string reason;   ///< what it takes it from: "the base is 0.4 m wide"
};

/// Smaller disks would overlap by more than a 1e-9 part of their radius: by how finely positions as large
/// as the scene's are held, or by how far its fastest disks go within the finest step in time.
FinestDisk finestDisk(const SceneDefinition& scene);

}  // namespace ratchet_sieve
