#include "finest_disk.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/resolution.h"

namespace ratchet_sieve
{

FinestDisk finestDisk(const SceneDefinition& scene)
{
  const double resolution = timeResolution(epochLength(timeScale(scene)));
  FinestDisk finest;
  const auto require = [&](double step, const char* what, double value, const char* unit)
  {
    if (const double radius = step / LARGEST_OVERLAP; radius > finest.radius)
      finest = {radius, fmt::format("{} {:.6g} {}", what, value, unit)};
  };
  const auto length = [&](double length, const char* what)
  { require(GAP_ROUNDING * length, what, length, "m"); };
  const auto speed = [&](double speed, const char* what) { require(speed * resolution, what, speed, "m/s"); };
  const auto after_fall = [&](double speed, double height)
  { return std::sqrt(speed * speed + 2.0 * scene.gravity * std::max(0.0, height)); };

  length(scene.base.width(), "the base's width is");
  length(std::max(scene.base.highest(), scene.base.depth()),
         scene.base.profile.empty() ? "base.tooth_height is" : "base.profile reaches");
  if (scene.boundary == Boundary::WALLED)
    length(wallHeight(scene), "base.wall_height is");
  const DriveBounds drive = driveBounds(scene.base);
  const bool sine = scene.base.horizontal_amplitude == 0.0 && scene.base.harmonics.empty();
  length(drive.displacement, sine ? "base.amplitude is" : "the drive's displacement is");
  speed(drive.speed, "the drive's speed is");
  if (scene.initial.empty() || scene.feed.any())
  {
    length(scene.pour.drop_height, "pour.drop_height is");
    speed(after_fall(scene.pour.speed, scene.pour.drop_height), "the poured disks come at");
  }
  for (const InitialDisk& disk : scene.initial)
  {
    length(std::max(std::abs(disk.x), std::abs(disk.y)), "a disk of initial is placed at");
    speed(after_fall(std::sqrt(disk.vx * disk.vx + disk.vy * disk.vy), disk.y), "a disk of initial comes at");
  }
  return finest;
}

}  // namespace ratchet_sieve
