#include "ratchet_sieve/core/resolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "model/orbit.h"
#include "ratchet_sieve/core/disks_of_scene.h"
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

/// As a fraction of a disk's radius; the accuracy goal of the engine.
constexpr double LARGEST_OVERLAP = 1e-9;

/// The fraction of that overlap for the displacement of the base within the time resolution. The rest is for
/// the rounding of its phase and of positions.
constexpr double BASE_SHARE = 0.5;

/// The same for the way that a disk falls within it at the end of an epoch.
constexpr double FALL_SHARE = 0.05;

/// Number of roundings in computing a gap, in units of the resolution of the largest position.
constexpr double ROUNDINGS_PER_GAP = 4.0;

double speedOf(const InitialDisk& disk)
{
  return std::sqrt(disk.vx * disk.vx + disk.vy * disk.vy);
}

}  // namespace

double startSpeed(const SceneDefinition& scene)
{
  double speed = std::max(scene.pour.speed, scene.contact.min_rebound_speed);
  for (const InitialDisk& disk : scene.initial)
    speed = std::max(speed, speedOf(disk));
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
  return LARGEST_OVERLAP * radius / (ROUNDINGS_PER_GAP * std::numeric_limits<double>::epsilon());
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

FinestDisk finestDisk(const SceneDefinition& scene)
{
  const double resolution = timeResolution(epochLength(timeScale(scene)));
  FinestDisk finest;
  const auto require = [&](double step, const char* what, double value, const char* unit)
  {
    const double radius = step / LARGEST_OVERLAP;
    if (!(radius > finest.radius))
      return;
    std::ostringstream reason;
    reason << what << ' ' << value << ' ' << unit;
    finest = {radius, reason.str()};
  };
  const auto length = [&](double length, const char* what)
  { require(ROUNDINGS_PER_GAP * std::numeric_limits<double>::epsilon() * length, what, length, "m"); };
  const auto speed = [&](double speed, const char* what) { require(speed * resolution, what, speed, "m/s"); };
  const auto after_fall = [&](double speed, double height)
  { return std::sqrt(speed * speed + 2.0 * scene.gravity * std::max(0.0, height)); };

  length(scene.base.width(), "the base's width is");
  length(std::max(scene.base.highest(), scene.base.depth()),
         scene.base.profile.empty() ? "base.tooth_height is" : "base.profile reaches");
  if (scene.boundary == Boundary::WALLED)
    length(wallHeight(scene), "base.wall_height is");
  const DriveBounds drive = driveBounds(scene.base);
  length(drive.displacement, Orbit(scene.base).empty() ? "base.amplitude is" : "the drive's displacement is");
  speed(drive.speed, "the drive's speed is");
  if (scene.initial.empty() || scene.feed.any())
  {
    length(scene.pour.drop_height, "pour.drop_height is");
    speed(after_fall(scene.pour.speed, scene.pour.drop_height), "the poured disks come at");
  }
  for (const InitialDisk& disk : scene.initial)
  {
    length(std::max(std::abs(disk.x), std::abs(disk.y)), "a disk of initial is placed at");
    speed(after_fall(speedOf(disk), disk.y), "a disk of initial comes at");
  }
  return finest;
}

}  // namespace ratchet_sieve
