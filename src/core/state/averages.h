#pragma once

#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/statistics/block_averages.h"

namespace ratchet_sieve
{

class SystemState;

/// Means over disks and time, from the disks' trajectories: of each species, then of each size class; and the
/// series behind their errors. Times are local to the epoch.
class Averages
{
public:
  explicit Averages(const SystemState& system);

  /// These disks, which have left, are about to be forgotten.
  void forget(const std::vector<std::uint32_t>& slots);

  /// The end of `settle`: the means begin anew.
  void restart();

  /// A block of the series ends.
  void endBlock(double time);

  std::vector<SpeciesMeans> means(double time) const;

  /// Per size class; without collision rates.
  std::vector<SpeciesMeans> sizeClassMeans(double time) const;

  /// Whether a series is recorded: always of a layer, whose disks move together; of independent disks if the
  /// scene requests an accuracy of <V_x>.
  bool keepsSeries() const { return layer_ || !groups_.blocks.empty(); }

  /// @param block_time of the original blocks [s]
  MeanSeries series(double block_time) const;

  /// @throws StateError if the state lacks a series that the scene requests; other series are discarded
  void archive(StateArchive& state);

private:
  /// Sums over the trajectories of one species or size class.
  struct Sums
  {
    double disks = 0.0;
    BlockSum path;  ///< displacement [m] and time [s]
    double displacement_squared = 0.0;
    double displacement_time = 0.0;
    double time_squared = 0.0;
    double translation = 0.0;  ///< weighted by mass, in units of the species'
    double rotation = 0.0;     ///< weighted by inertia, in units of the species'

    void archive(StateArchive& state)
    {
      state(disks, path, displacement_squared, displacement_time, time_squared, translation, rotation);
    }

    operator const BlockSum&() const { return path; }
    SpeciesMeans means(const SpeciesDefinition& species) const;
  };

  /// The growth of sums from block to block.
  template <typename Sum>
  struct Series
  {
    std::vector<Sum> gone;          ///< of disks removed by compaction
    std::vector<Sum> at_block_end;  ///< at the end of the last block
    std::vector<BlockAverages> blocks;

    void begin(std::size_t rows)
    {
      gone.assign(rows, {});
      at_block_end.assign(rows, {});
      blocks.assign(rows, {});
    }
    void endBlock(std::vector<Sum>&& now);
  };

  /// Displacement and time of a disk's trajectory as far as it counts, up to `time` or until it left.
  BlockSum path(std::uint32_t slot, double time) const;
  void add(std::uint32_t slot, double time, std::vector<Sums>& sums) const;
  void add(std::uint32_t slot, double time, std::vector<BlockSum>& groups) const;

  template <typename Sum>
  std::vector<Sum> sums(const Series<Sum>& series, double time) const;
  SpeciesMeans meansOf(std::size_t row, const std::vector<Sums>& sums) const;

  const SystemState& system_;
  bool layer_;                           ///< whether disks collide with each other
  std::vector<std::size_t> species_of_;  ///< of each row: a species or a size class
  Series<Sums> means_;                   ///< blocks of a layer only
  Series<BlockSum> groups_;              ///< per group of a species; empty if none is requested
};

}  // namespace ratchet_sieve
