#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// The motion of the disks and the base, in a format that other programs read. A sink for a run's scene, and
/// for frames of the disks and of the base at the same times. The files appear at commit().
class TrajectoryFile : public FrameSink
{
public:
  bool wants(FrameKind kind) const override;

  /// @throws std::invalid_argument if there is no scene, or no base at the time of the disks
  void take(const AnyFrame& frame) override;

  /// @throws OutputError if the files could not be written completely
  virtual void commit() = 0;

protected:
  /// The machine at one instant.
  struct Instant
  {
    const SceneDefinition& scene;
    const DriveState& base;
    const ParticleFrame& particles;
  };

private:
  virtual void write(const Instant& instant) = 0;

  std::optional<SceneDefinition> scene_;
  std::optional<BaseFrame> base_;
};

/// Opens the files of a trajectory. The ending of `path` selects the format: .xyz and .extxyz are extended
/// XYZ, .pvd is a series of VTK PolyData. @throws OutputError if there is another ending, or if a file cannot
/// be written
std::unique_ptr<TrajectoryFile> openTrajectory(const std::string& path);

/// All that a trajectory writes: its file and what lies beside it. Nothing for an empty path.
std::vector<std::string> trajectoryPaths(const std::string& path);

/// The rates of a trajectory's frames: disks and base at `rate` [1/s], see FrameRates.
FrameRates trajectoryRates(double rate);

}  // namespace ratchet_sieve
