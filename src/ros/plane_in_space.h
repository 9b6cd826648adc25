#pragma once

#include <Eigen/Geometry>

#include "ratchet_sieve/core/observation.h"

/// The plane of the simulation in the space of ROS: x to the right, z up, y away from the viewer.
namespace ratchet_sieve
{

/// The rotation by the inclination. It is positive if the right end is raised, which is a negative rotation
/// about y.
inline Eigen::Quaterniond inclinationInSpace(const DriveState& base)
{
  return Eigen::Quaterniond(Eigen::AngleAxisd(-base.inclination, Eigen::Vector3d::UnitY()));
}

/// The drive's displacement, in the world frame [m].
inline Eigen::Vector3d displacementInSpace(const DriveState& base)
{
  return {base.horizontal_displacement, 0.0, base.displacement};
}

}  // namespace ratchet_sieve
