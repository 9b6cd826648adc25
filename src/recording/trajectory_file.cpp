#include "ratchet_sieve/recording/trajectory_file.h"

#include <cstddef>
#include <filesystem>
#include <stdexcept>

#include <fmt/ostream.h>
#include <Eigen/Geometry>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/scene/scene_file.h"

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

/// run.xyz -> run_base.xyz
std::string basePath(const std::string& path)
{
  const std::filesystem::path whole(path);
  return (whole.parent_path() / (whole.stem().string() + "_base" + whole.extension().string())).string();
}

/// The path itself. @throws OutputError if it ends otherwise than a trajectory
const std::string& withKnownEnding(const std::string& path)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".pvd")
    throw OutputError(path +
                      ": for ParaView use run.write(\"FILE.pvd\") of the Python package; the file's ending "
                      "must be one of .xyz, .extxyz");
  if (ending != ".xyz" && ending != ".extxyz")
    throw OutputError(path +
                      ": unknown format of a trajectory; the file's ending must be one of .xyz, .extxyz");
  return path;
}

/// World position of the base's foot, where its first tooth begins [m].
Eigen::Vector2d footOf(const DriveState& base)
{
  return {base.horizontal_displacement, base.displacement};
}

/// A vector (s, n) of the base in the world frame.
Eigen::Vector2d outOfBase(const DriveState& base, const Eigen::Vector2d& vector)
{
  return Eigen::Rotation2Dd(base.inclination) * vector;
}

/// Corners of the base and its walls from left to right, in the world frame [m].
std::vector<Eigen::Vector2d> baseOutline(const SceneDefinition& scene, const DriveState& base)
{
  const std::vector<OutlineCorner> tooth = scene.base.outline();
  std::vector<Eigen::Vector2d> corners;
  for (int k = 0; k < scene.base.teeth; ++k)
    for (std::size_t i = k > 0 ? 1 : 0; i < tooth.size(); ++i)  // a tooth begins where the last one ends
      corners.emplace_back(k * scene.base.toothWidth() + tooth[i].s, tooth[i].n);
  if (scene.boundary == Boundary::WALLED && scene.base.wall_height > 0.0)
  {
    corners.insert(corners.begin(), {corners.front().x(), scene.base.wall_height});
    corners.emplace_back(corners.back().x(), scene.base.wall_height);
  }
  for (Eigen::Vector2d& corner : corners)
    corner = footOf(base) + outOfBase(base, corner);
  return corners;
}

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

}  // namespace

TrajectoryFile::TrajectoryFile(const std::string& path)
    : disks_file_(withKnownEnding(path)), base_file_(basePath(path))
{
}

bool TrajectoryFile::wants(FrameKind kind) const
{
  return kind == FrameKind::SCENE || kind == FrameKind::BASE || kind == FrameKind::PARTICLES;
}

void TrajectoryFile::take(const AnyFrame& frame)
{
  if (const SceneFrame* scene = frame.as<SceneFrame>())
    scene_ = sceneFromText(scene->yaml, "scene").definition;
  else if (const BaseFrame* base = frame.as<BaseFrame>())
    base_ = *base;
  else if (const ParticleFrame* particles = frame.as<ParticleFrame>())
  {
    if (!scene_ || !base_ || base_->time != particles->time)
      throw std::invalid_argument("a trajectory needs the scene, and the base at the time of the disks");
    write(*particles);
  }
}

void TrajectoryFile::write(const ParticleFrame& particles)
{
  const SceneDefinition& scene = *scene_;
  const DriveState& base = base_->base;
  std::ostream& disks = disks_file_.stream();
  disks << frameHead(particles.disks.size(), scene, base, particles.time, DISK_COLUMNS);
  for (const DiskState& disk : particles.disks)
  {
    const double radius = radiusOf(disk, scene.species);
    fmt::print(disks, "{} {} {} 0 {} {} {} 0 {} {} {} 0 0 {} {}\n", scene.species[disk.species].name, disk.x,
               disk.y, disk.id, disk.vx, disk.vy, radius, massOf(disk, scene.species), disk.angle, disk.spin,
               disk.displacement);
  }

  const std::vector<Eigen::Vector2d> corners = baseOutline(scene, base);
  base_file_.stream() << frameHead(corners.size(), scene, base, particles.time, CORNER_COLUMNS);
  for (const Eigen::Vector2d& corner : corners)
    fmt::print(base_file_.stream(), "base {} {} 0 {}\n", corner.x(), corner.y(),
               CORNER_RADIUS * scene.base.toothWidth());
}

void TrajectoryFile::commit()
{
  disks_file_.finish();
  base_file_.finish();
  disks_file_.commit();
  base_file_.commit();
}

std::vector<std::string> trajectoryPaths(const std::string& path)
{
  return path.empty() ? std::vector<std::string>() : std::vector<std::string>{path, basePath(path)};
}

FrameRates trajectoryRates(double rate)
{
  FrameRates rates{0.0, 0.0, 0.0, 0.0, 0.0};
  rates.particles = rates.base = rate;
  return rates;
}

}  // namespace ratchet_sieve
