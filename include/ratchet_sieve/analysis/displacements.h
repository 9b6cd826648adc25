#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "ratchet_sieve/recording/frames.h"
#include "ratchet_sieve/statistics/block_averages.h"

namespace ratchet_sieve
{

/// <V_x> of one species.
struct DriftVelocity
{
  std::size_t disks = 0;       ///< disks observed for a time above 0
  std::optional<double> mean;  ///< sum of displacements / sum of times [m/s], world x
  /// Standard error of that ratio [m/s]: the larger of the one over disks (at least two) and the one over
  /// blocks of time (see BlockAverages).
  std::optional<double> mean_stderr;
};

/// Measures the displacement of each disk between its first frame after `settle` and its last frame.
class DisplacementTracker
{
public:
  /// @param settle time before which nothing is measured [s]
  /// @param independent disks do not collide with each other: the scatter between disks is the whole error
  DisplacementTracker(std::size_t species_count, double settle, bool independent);

  /// @pre frames come at equal intervals, as a Run takes them
  void add(const ParticleFrame& frame);

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

/// A histogram of the displacements, since entry, of one species' disks that are in the machine at one time.
struct DisplacementDistribution
{
  double time = 0.0;  ///< [s]
  std::size_t species = 0;
  double first_edge = 0.0;  ///< of the first bin [m]
  double bin_width = 0.0;   ///< [m]
  std::vector<std::uint64_t> counts;

  std::uint64_t total() const;
  double edge(std::size_t bin) const { return first_edge + static_cast<double>(bin) * bin_width; }
  double density(std::size_t bin) const;  ///< [1/m]; integrates to 1
};

/// Distributions at several times of a run.
class DisplacementDistributions
{
public:
  /// @param times ascending [s]: the first frame at or after each time is used
  DisplacementDistributions(std::size_t species_count, std::vector<double> times);

  void add(const ParticleFrame& frame);

  /// By time, then by species, without those that have no disk. The last time is always that of the last
  /// frame. All have the same bins, so that they can be compared.
  std::vector<DisplacementDistribution> distributions() const;

private:
  struct Snapshot
  {
    double time = 0.0;
    std::vector<std::vector<double>> displacements;  ///< per species [m]
  };

  std::size_t species_count_;
  std::vector<double> times_;
  std::size_t next_ = 0;
  std::vector<Snapshot> snapshots_;
  Snapshot last_;
};

}  // namespace ratchet_sieve
