#include "xyz_trajectory.h"

#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "base_outline.h"
#include "ratchet_sieve/core/layer.h"
#include "trajectory_paths.h"

namespace ratchet_sieve
{
namespace
{

/// OVITO maps these names to its own properties, except for `angle` and `displacement`.
constexpr const char* DISK_COLUMNS =
    "type:S:1:pos:R:3:id:I:1:velo:R:3:radius:R:1:mass:R:1:angle:R:1:omega:R:3:displacement:R:1";
constexpr const char* CORNER_COLUMNS = "type:S:1:pos:R:3:radius:R:1";

/// Radius of the dots that show the corners of the base [widths of a tooth].
constexpr double CORNER_RADIUS = 0.02;

/// The two lines above the rows of a frame.
std::string frameHead(std::size_t rows, const SceneDefinition& scene, const DriveState& base, double time,
                      const char* columns)
{
  const double depth = largestDiameter(scene);
  const Eigen::Vector2d foot = footOf(base);
  const Eigen::Vector2d along = outOfBase(base, {scene.base.width(), 0.0});
  return fmt::format(
      "{}\nLattice=\"{} {} 0 {} {} 0 0 0 {}\" Origin=\"{} {} {}\" pbc=\"{} F F\" Time={} Properties={}\n",
      rows, along.x(), along.y(), -along.y(), along.x(), depth, foot.x(), foot.y(), -0.5 * depth,
      scene.boundary == Boundary::PERIODIC ? 'T' : 'F', time, columns);
}

void writeText(AtomicFile& file, const fmt::memory_buffer& text)
{
  file.stream().write(text.data(), static_cast<std::streamsize>(text.size()));
}

}  // namespace

XyzTrajectory::XyzTrajectory(const std::string& path) : disks_(path), base_(basePath(path)) {}

void XyzTrajectory::write(const Instant& instant)
{
  const auto& [scene, base, particles] = instant;
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{}", frameHead(particles.disks.size(), scene, base, particles.time, DISK_COLUMNS));
  for (const DiskState& disk : particles.disks)
  {
    const double radius = radiusOf(disk, scene.species);
    fmt::format_to(out, "{} {} {} 0 {} {} {} 0 {} {} {} 0 0 {} {}\n", scene.species[disk.species].name,
                   disk.x, disk.y, disk.id, disk.vx, disk.vy, radius,
                   scene.species[disk.species].massOf(radius), disk.angle, disk.spin, disk.displacement);
  }
  writeText(disks_, text);

  text.clear();
  const std::vector<Eigen::Vector2d> corners = baseOutline(scene, base);
  fmt::format_to(out, "{}", frameHead(corners.size(), scene, base, particles.time, CORNER_COLUMNS));
  for (const Eigen::Vector2d& corner : corners)
    fmt::format_to(out, "base {} {} 0 {}\n", corner.x(), corner.y(), CORNER_RADIUS * scene.base.toothWidth());
  writeText(base_, text);
}

void XyzTrajectory::commit()
{
  disks_.finish();
  base_.finish();
  disks_.commit();
  base_.commit();
}

}  // namespace ratchet_sieve
