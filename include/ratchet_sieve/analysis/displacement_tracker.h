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
  std::size_t disks = 0;       ///< disks observed for a time above 0
  std::optional<double> mean;  ///< sum of displacements / sum of times [m/s], world x
  std::optional<double>
      mean_stderr;  ///< standard error of that ratio [m/s]: the larger of the one over disks (at least two)
                    ///< and the one over blocks of time (see BlockAverages)
};

/// Measures the displacement of each disk between its first frame after `settle` and its last frame.
class DisplacementTracker
{
public:
  /// @param settle time before which nothing is measured [s]
  /// @param independent disks do not collide with each other: the scatter between disks is the whole error
  DisplacementTracker(std::size_t species_count, double settle, bool independent);

  /// @pre frames come at equal intervals, as a FrameSampler takes them
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
