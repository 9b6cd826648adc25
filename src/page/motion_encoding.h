#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// What numbers of a page's motion are multiples of. Other units are the same for all runs.
struct MotionUnits
{
  explicit MotionUnits(const SceneDefinition& scene);

  double position;  ///< [m]
  double velocity;  ///< [m/s]
  double radius;    ///< [m]
};

/// A disk's state in such units.
struct RoundedDisk
{
  std::uint32_t id, species;
  std::int32_t x, y, vx, vy, angle, spin, radius;
};

struct RoundedFrame
{
  double time = 0.0;  ///< [s]
  std::vector<RoundedDisk> disks;
};

/// The disks whose id is a multiple of `disk_every`.
RoundedFrame rounded(const ParticleFrame& frame, const SceneDefinition& scene, const MotionUnits& units,
                     std::uint32_t disk_every);

/// A motion as a page holds it.
struct EncodedMotion
{
  nlohmann::ordered_json description;
  std::string bytes;
};

/// The description: `frames` (their number), the units `position_unit` [m], `velocity_unit` [m/s],
/// `positions_per_velocity` [s], `spin_unit` [rad/s], `angle_steps` of a turn, `radius_unit` [m], and the
/// numbers of `tracks` and `states`. A track is a disk in consecutive frames.
///
/// The bytes (see deflated(), bytePlanes()): the times of the frames [s]; columns of the tracks: id, species,
/// radius, first frame, number of frames; then columns of the states, track by track: vx, vy, x, y, spin,
/// angle. x and y are differences from the last frame's position moved on by the mean of both velocities;
/// angle is the difference from the last, from -angle_steps / 2 on; in a track's first state they are the
/// numbers themselves.
EncodedMotion encode(const std::vector<RoundedFrame>& frames, const MotionUnits& units);

}  // namespace ratchet_sieve
