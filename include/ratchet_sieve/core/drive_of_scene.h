#pragma once

#include <Eigen/Core>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/observation.h"

namespace ratchet_sieve
{

/// The drive as a scene has it: bounds on |D|, |dD/dt| and |d2D/dt2|, which a drive without harmonics comes
/// to.
struct DriveBounds
{
  double displacement;  ///< [m]
  double speed;         ///< [m/s]
  double acceleration;  ///< [m/s^2]
};

DriveBounds driveBounds(const BaseDefinition& base);

/// Whether the drive moves the base at all, given a frequency.
bool hasStroke(const BaseDefinition& base);

/// The base at another setpoint of A: the whole drive is scaled, as one knob of a feeder scales it. Where A
/// is 0 in `base`, there is nothing to scale by, and the rest stays as it is.
BaseDefinition withAmplitude(const BaseDefinition& base, double amplitude);

/// The base as its definition has it, `time` after the drive was at its phase [s].
DriveState driveStateAt(const BaseDefinition& base, double time);

}  // namespace ratchet_sieve
