#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// <V_x> of one species.
struct DriftVelocity
{
  std::size_t disks = 0;              ///< that were seen for some time
  std::optional<double> mean;         ///< sum of displacements / sum of times [m/s], world x
  std::optional<double> mean_stderr;  ///< of that ratio, over disks; nothing for fewer than two [m/s]
};

/// How far each disk came between its first frame after `settle` and its last.
class DisplacementTracker
{
public:
  /// @param settle time before which nothing counts [s]
  DisplacementTracker(std::size_t species_count, double settle);

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

  std::size_t species_count_;
  double settle_;
  std::unordered_map<std::uint32_t, Track> tracks_;  ///< by id
};

}  // namespace ratchet_sieve
