#pragma once

#include <cstring>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// Equality of frames bit for bit: -0 is not 0, and a NaN is itself.
inline bool sameBits(double a, double b)
{
  return std::memcmp(&a, &b, sizeof a) == 0;
}

inline bool sameBits(const std::optional<double>& a, const std::optional<double>& b)
{
  return a.has_value() == b.has_value() && (!a || sameBits(*a, *b));
}

inline bool sameBits(const DiskState& a, const DiskState& b)
{
  return a.id == b.id && a.species == b.species && sameBits(a.x, b.x) && sameBits(a.y, b.y) &&
         sameBits(a.angle, b.angle) && sameBits(a.vx, b.vx) && sameBits(a.vy, b.vy) &&
         sameBits(a.spin, b.spin) && sameBits(a.displacement, b.displacement);
}

inline bool sameBits(const SpeciesBins& a, const SpeciesBins& b)
{
  return a.left == b.left && a.right == b.right && a.on_base == b.on_base;
}

inline bool sameBits(const SpeciesMeans& a, const SpeciesMeans& b)
{
  return sameBits(a.mean_vx, b.mean_vx) && sameBits(a.mean_vx_stderr, b.mean_vx_stderr) &&
         sameBits(a.kinetic_translational, b.kinetic_translational) &&
         sameBits(a.kinetic_rotational, b.kinetic_rotational);
}

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b)
{
  if (a.size() != b.size())
    return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (!sameBits(a[k], b[k]))
      return false;
  return true;
}

inline bool sameBits(const ParticleFrame& a, const ParticleFrame& b)
{
  return sameBits(a.time, b.time) && sameBits(a.disks, b.disks);
}

inline bool sameBits(const BinFrame& a, const BinFrame& b)
{
  return sameBits(a.time, b.time) && a.species == b.species && sameBits(a.bins, b.bins) &&
         sameBits(a.quality, b.quality) && sameBits(a.processed, b.processed);
}

inline bool sameBits(const BaseFrame& a, const BaseFrame& b)
{
  return sameBits(a.time, b.time) && sameBits(a.base.inclination, b.base.inclination) &&
         sameBits(a.base.frequency, b.base.frequency) && sameBits(a.base.amplitude, b.base.amplitude) &&
         sameBits(a.base.commanded_inclination, b.base.commanded_inclination) &&
         sameBits(a.base.commanded_frequency, b.base.commanded_frequency) &&
         sameBits(a.base.commanded_amplitude, b.base.commanded_amplitude) &&
         sameBits(a.base.phase, b.base.phase) && sameBits(a.base.displacement, b.base.displacement) &&
         sameBits(a.base.velocity, b.base.velocity) &&
         sameBits(a.base.horizontal_displacement, b.base.horizontal_displacement) &&
         sameBits(a.base.horizontal_velocity, b.base.horizontal_velocity);
}

inline bool sameBits(const CollisionRates& a, const CollisionRates& b)
{
  return sameBits(a.disk_disk, b.disk_disk) && sameBits(a.left_slope, b.left_slope) &&
         sameBits(a.right_slope, b.right_slope) && sameBits(a.apex, b.apex) && sameBits(a.wall, b.wall);
}

inline bool sameBits(const StatisticsFrame& a, const StatisticsFrame& b)
{
  const CollisionCounts& p = a.collisions;
  const CollisionCounts& q = b.collisions;
  return sameBits(a.time, b.time) && a.species == b.species && sameBits(a.means, b.means) &&
         sameBits(a.window_start, b.window_start) && sameBits(a.window_end, b.window_end) &&
         sameBits(a.granular_temperature, b.granular_temperature) && p.disk_disk == q.disk_disk &&
         p.left_slope == q.left_slope && p.right_slope == q.right_slope && p.apex == q.apex &&
         p.wall == q.wall && a.events == b.events && sameBits(a.collision_rates, b.collision_rates) &&
         sameBits(a.real_time_factor, b.real_time_factor) && sameBits(a.max_overlap, b.max_overlap);
}

inline bool sameBits(const CommandFrame& a, const CommandFrame& b)
{
  return sameBits(a.time, b.time) && a.kind == b.kind && sameBits(a.values, b.values) &&
         a.species == b.species && a.count == b.count;
}

inline bool sameBits(const SceneFrame& a, const SceneFrame& b)
{
  return sameBits(a.time, b.time) && sameBits(a.start_time, b.start_time) && a.yaml == b.yaml &&
         a.scene_hash == b.scene_hash && a.seed == b.seed && a.version == b.version;
}

/// But for how fast the run went, which the topics and the recording measure each for themselves.
inline bool sameButForSpeed(StatisticsFrame a, StatisticsFrame b)
{
  a.real_time_factor = b.real_time_factor = 0.0;
  return sameBits(a, b);
}

}  // namespace ratchet_sieve
