#include "ratchet_sieve/recording/trajectory_file.h"

#include <array>
#include <filesystem>
#include <stdexcept>

#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "trajectory_paths.h"
#include "vtk_trajectory.h"
#include "xyz_trajectory.h"

namespace ratchet_sieve
{
namespace
{

template <typename Format>
std::unique_ptr<TrajectoryFile> openFormat(const std::string& path)
{
  return std::make_unique<Format>(path);
}

struct TrajectoryFormat
{
  const char* ending;
  std::unique_ptr<TrajectoryFile> (*open)(const std::string& path);
};

constexpr std::array<TrajectoryFormat, 3> TRAJECTORY_FORMATS = {{{".xyz", openFormat<XyzTrajectory>},
                                                                 {".extxyz", openFormat<XyzTrajectory>},
                                                                 {".pvd", openFormat<VtkTrajectory>}}};

}  // namespace

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
    write({*scene_, base_->base, *particles});
  }
}

std::unique_ptr<TrajectoryFile> openTrajectory(const std::string& path)
{
  const std::string ending = std::filesystem::path(path).extension().string();
  std::string allowed;
  for (const TrajectoryFormat& format : TRAJECTORY_FORMATS)
  {
    if (ending == format.ending)
      return format.open(path);
    allowed += (allowed.empty() ? "" : ", ") + std::string(format.ending);
  }
  throw OutputError(path + ": unknown format of a trajectory; the file's ending must be one of " + allowed);
}

std::vector<std::string> trajectoryPaths(const std::string& path)
{
  return path.empty() ? std::vector<std::string>()
                      : std::vector<std::string>{path, basePath(path), framesPath(path)};
}

FrameRates trajectoryRates(double rate)
{
  FrameRates rates{0.0, 0.0, 0.0, 0.0, 0.0};
  rates.particles = rates.base = rate;
  return rates;
}

}  // namespace ratchet_sieve
