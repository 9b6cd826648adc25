#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

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

  void take(const ParticleFrame& frame);

  /// By time, then by species, without those that have no disk. The last time is always that of the last
  /// frame. All have the same bins, so that they can be compared.
  std::vector<DisplacementDistribution> distributions() const;

private:
  struct Snapshot
  {
    double time = 0.0;
    std::vector<std::vector<double>> displacements;  ///< per species [m]
  };

  Snapshot snapshot(const ParticleFrame& frame) const;

  std::size_t species_count_;
  std::vector<double> times_;
  std::size_t next_ = 0;
  std::vector<Snapshot> snapshots_;
  Snapshot last_;
};

}  // namespace ratchet_sieve
