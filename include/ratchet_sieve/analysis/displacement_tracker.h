#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ratchet_sieve/core/block_averages.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// <V_x> of one species.
struct DriftVelocity
{
  std::size_t disks = 0;       ///< that were seen for some time
  std::optional<double> mean;  ///< sum of displacements / sum of times [m/s], world x
  std::optional<double>
      mean_stderr;  ///< standard error of that ratio [m/s]: the larger one of that over disks
                    ///< (two at least) and that over blocks of time (see BlockAverages)
};

/// How far each disk came between its first frame after `settle` and its last.
class DisplacementTracker
{
public:
  /// @param settle time before which nothing counts [s]
  /// @param independent disks do not see each other: what they scatter is the whole error
  DisplacementTracker(std::size_t species_count, double settle, bool independent);

  /// Frames come at even intervals, as a FrameSampler takes them.
  void take(const ParticleFrame& frame);

  /// Per species.
  std::vector<DriftVelocity> velocities() const;

private:
  struct Track
  {
    std::uint32_t species = 0;
    double first_time = 0.0;
    double first_displacement = 0.0;
    double last_time = 0.0;
    double last_displacement = 0.0;
  };

  double settle_;
  bool independent_;
  std::unordered_map<std::uint32_t, Track> tracks_;  ///< by id
  std::vector<BlockAverages> blocks_;                ///< per species, from frame to frame
};

}  // namespace ratchet_sieve
