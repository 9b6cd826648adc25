#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/block_averages.h"
#include "ratchet_sieve/core/observation.h"
#include "state/observer.h"

namespace ratchet_sieve
{

class SystemState;
struct SpeciesDefinition;
struct Trajectory;

/// Means over disks and time, from the disks' trajectories: of each species, then of each size class. Times
/// are local to the epoch.
class SpeciesAverages final : public Observer
{
public:
  /// @param system outlives this
  explicit SpeciesAverages(const SystemState& system);

  void compact(const Compaction& compaction) override;
  void restart(double time) override;

  /// For the errors of the means; see BlockAverages. Independent disks need no series of their mean.
  void endBlock(double time) override;

  /// Of a species.
  const BlockAverages& blocks(std::size_t species) const { return blocks_[species]; }

  std::vector<SpeciesMeans> means(double time) const;

  /// Per size class; without collision rates.
  std::vector<SpeciesMeans> sizeClassMeans(double time) const;

  void archive(StateArchive& state) override;

private:
  /// Mass and moment of inertia of a disk, in units of its species'.
  struct Weights
  {
    double mass;
    double inertia;
  };

  /// Sums over the trajectories of one species.
  struct Sums
  {
    double disks = 0.0;
    double displacement = 0.0;
    double time = 0.0;
    double displacement_squared = 0.0;
    double displacement_time = 0.0;
    double time_squared = 0.0;
    double translation = 0.0;  ///< weighted by mass
    double rotation = 0.0;     ///< weighted by inertia

    /// @param x end of the trajectory [m], @param until its time, in the run's time [s]
    void add(const Trajectory& trajectory, const Weights& weights, double x, double until);
    void archive(StateArchive& state)
    {
      state(disks, displacement, time, displacement_squared, displacement_time, time_squared, translation,
            rotation);
    }
    SpeciesMeans means(const SpeciesDefinition& species) const;
  };

  /// Adds to the sums of the disk's species, and of its size class if it has one.
  void add(std::uint32_t slot, const Trajectory& trajectory, double x, double until,
           std::vector<Sums>& sums) const;
  SpeciesMeans meansOf(std::size_t group, const std::vector<Sums>& sums) const;
  Weights weights(std::uint32_t slot) const;

  /// Adds the trajectory of a disk that has left, if it counts.
  void addLeft(std::uint32_t slot, std::vector<Sums>& sums) const;
  std::vector<Sums> sums(double time) const;

  const SystemState& system_;
  std::vector<std::size_t> species_of_;  ///< of each group: a species or a size class
  std::vector<Sums> gone_;               ///< per group, of disks removed by compaction
  std::vector<Sums> at_block_end_;       ///< per group, at the end of the last block
  std::vector<BlockAverages> blocks_;    ///< per group
};

}  // namespace ratchet_sieve
