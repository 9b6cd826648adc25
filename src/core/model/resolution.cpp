#include "ratchet_sieve/core/resolution.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/orbit.h"
#include "ratchet_sieve/core/drive_of_scene.h"

namespace ratchet_sieve
{
namespace
{
/// An epoch is at least this many of the machine's time scales long. Then its end costs nothing noticeable,
/// and times within it have a resolution of 2^-48 of a time scale.
constexpr double SCALES_PER_EPOCH = 8.0;

/// In units of a double's resolution at the end of an epoch.
constexpr double RESOLUTION_STEPS = 4.0;

/// The fraction of that overlap for the displacement of the base within the time resolution. The rest is for
/// the rounding of its phase and of positions.
constexpr double BASE_SHARE = 0.5;

/// The same for the way that a disk falls within it at the end of an epoch.
constexpr double FALL_SHARE = 0.05;

}  // namespace

double startSpeed(const SceneDefinition& scene)
{
  double speed = std::max(scene.pour.speed, scene.contact.min_rebound_speed);
  for (const InitialDisk& disk : scene.initial)
    speed = std::max(speed, std::sqrt(disk.vx * disk.vx + disk.vy * disk.vy));
  return speed;
}

double timeScale(const SceneDefinition& scene)
{
  const BaseDefinition& base = scene.base;
  double scale = std::numeric_limits<double>::infinity();
  // A frequency without an amplitude causes no motion.
  if (base.frequency > 0.0 && hasStroke(base))
    scale = 1.0 / (base.frequency * Orbit(base).highestMultiple());
  if (scene.gravity > 0.0)
    scale = std::min(scale, std::sqrt(base.toothWidth() / scene.gravity));
  if (const double speed = startSpeed(scene); speed > 0.0)
    scale = std::min(scale, base.toothWidth() / speed);
  return std::isfinite(scale) ? scale : 1.0;
}

double epochLength(double time_scale)
{
  return std::exp2(std::ceil(std::log2(SCALES_PER_EPOCH * time_scale)));
}

double farthestPlace(double radius)
{
  return LARGEST_OVERLAP * radius / GAP_ROUNDING;
}

double longestEpoch(double speed, double radius)
{
  const double step = BASE_SHARE * LARGEST_OVERLAP * radius / speed;
  return std::exp2(std::floor(std::log2(step / timeResolution(1.0))));
}

double longestFall(double gravity, double radius)
{
  const double squared = FALL_SHARE * LARGEST_OVERLAP * radius / (gravity * timeResolution(1.0));
  return std::exp2(std::floor(0.5 * std::log2(squared)));
}

double timeResolution(double epoch_length)
{
  return RESOLUTION_STEPS * std::numeric_limits<double>::epsilon() * epoch_length;
}

}  // namespace ratchet_sieve
