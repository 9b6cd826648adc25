#pragma once

#include <cstddef>
#include <string>

#include "atomic_folder.h"
#include "ratchet_sieve/recording/atomic_file.h"
#include "ratchet_sieve/recording/trajectory_file.h"

namespace ratchet_sieve
{

/// Two series of VTK PolyData for ParaView: the disks as points, and the base as a line. Each has a
/// collection with its times: FILE, and FILE with `_base` before the ending. Their frames are in a folder
/// beside them: FILE without its ending and with `_frames`. SI units, world frame, z = 0. Numbers are read
/// back bit for bit.
class VtkTrajectory : public TrajectoryFile
{
public:
  /// @throws OutputError
  explicit VtkTrajectory(const std::string& path);

  void commit() override;

private:
  void write(const Instant& instant) override;

  AtomicFile disks_;
  AtomicFile base_;
  AtomicFolder frames_;
  std::string folder_;  ///< of the frames, relative to the collections, as XML
  std::size_t next_ = 0;
};

}  // namespace ratchet_sieve
