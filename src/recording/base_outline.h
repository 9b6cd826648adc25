#pragma once

#include <vector>

#include <Eigen/Core>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/observation.h"

namespace ratchet_sieve
{

/// The foot of the base, s = 0, n = 0, in the world frame [m].
Eigen::Vector2d footOf(const DriveState& base);

/// A vector of the frame of the base in the world frame.
Eigen::Vector2d outOfBase(const DriveState& base, const Eigen::Vector2d& vector);

/// The corners of the base from left to right, in the world frame [m]. Where the scene gives the height of
/// the walls, the outline begins and ends at their tops.
std::vector<Eigen::Vector2d> baseOutline(const SceneDefinition& scene, const DriveState& base);

}  // namespace ratchet_sieve
