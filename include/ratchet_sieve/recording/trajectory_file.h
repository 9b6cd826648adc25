#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// The motion of the disks and the base as extended XYZ, as OVITO and ASE read it:
/// https://github.com/libAtoms/extxyz. One file of the disks, and one of the corners of the base, with
/// `_base` before the ending. SI units, world frame, z = 0. Numbers are read back bit for bit.
///
/// The species' name is in the column `type`, because ASE takes only chemical elements in `species`.
///
/// The cell begins at the foot of the base. It is as long as the base and as high as it is long, in the pose
/// of the base, and one largest diameter deep.
///
/// A sink for a run's scene, and for frames of the disks and of the base at the same times.
class TrajectoryFile : public FrameSink
{
public:
  /// @throws OutputError if `path` does not end in .xyz or .extxyz, or if a file cannot be written
  explicit TrajectoryFile(const std::string& path);

  bool wants(FrameKind kind) const override;

  /// @throws std::invalid_argument if there is no scene, or no base at the time of the disks
  void take(const AnyFrame& frame) override;

  /// The files appear. @throws OutputError if they could not be written completely
  void commit();

private:
  void write(const ParticleFrame& particles);

  std::optional<SceneDefinition> scene_;
  std::optional<BaseFrame> base_;
  AtomicFile disks_file_;
  AtomicFile base_file_;
};

/// All that a trajectory writes: its file and the one beside it. Nothing for an empty path.
std::vector<std::string> trajectoryPaths(const std::string& path);

/// The rates of a trajectory's frames: disks and base at `rate` [1/s], see FrameRates.
FrameRates trajectoryRates(double rate);

}  // namespace ratchet_sieve
