#pragma once

#include <string>

#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/trajectory_file.h"

namespace ratchet_sieve
{

/// Extended XYZ, as OVITO and ASE read it: https://github.com/libAtoms/extxyz. One file of the disks, and one
/// of the corners of the base, with `_base` before the ending. SI units, world frame, z = 0. Numbers are read
/// back bit for bit.
///
/// The species' name is in the column `type`, because ASE takes only chemical elements in `species`.
///
/// The cell begins at the foot of the base. It is as long as the base and as high as it is long, in the pose
/// of the base, and one largest diameter deep.
class XyzTrajectory : public TrajectoryFile
{
public:
  /// @throws OutputError
  explicit XyzTrajectory(const std::string& path);

  void commit() override;

private:
  void write(const Instant& instant) override;

  AtomicFile disks_;
  AtomicFile base_;
};

}  // namespace ratchet_sieve
