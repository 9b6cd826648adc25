#pragma once

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/results.h"

namespace ratchet_sieve
{

/// Bounds on |D|, |dD/dt| and |d2D/dt2| of the drive at the scene's setpoints. A drive without harmonics
/// reaches them.
struct DriveBounds
{
  double displacement;  ///< [m]
  double speed;         ///< [m/s]
  double acceleration;  ///< [m/s^2]
};

DriveBounds driveBounds(const BaseDefinition& base);

/// The largest acceleration of the drive downwards in the world [m/s^2]: above gravity, the base throws its
/// disks up.
double peakLift(const BaseDefinition& base);

/// Whether the drive moves the base at a frequency above 0.
bool hasStroke(const BaseDefinition& base);

/// The base with amplitude A set to `amplitude`: all parts of the drive are scaled in proportion, as a
/// feeder's single amplitude setting scales them. If A is 0 in `base`, only A is changed.
BaseDefinition withAmplitude(const BaseDefinition& base, double amplitude);

/// The state of the base at its defined setpoints, `time` [s] after the drive had its initial phase.
DriveState driveStateAt(const BaseDefinition& base, double time);

}  // namespace ratchet_sieve
