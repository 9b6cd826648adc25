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

  /// The path of a disk that has left counts from now on without it.
  void close(std::uint32_t slot);

  /// The end of `settle`: the means begin anew.
  void restart();

  /// A block of the series ends.
  void endBlock(double time);

  std::vector<SpeciesMeans> means(double time) const;

  /// Per size class; without collision rates.
  std::vector<SpeciesMeans> sizeClassMeans(double time) const;

  /// Whether a series is recorded: always of a layer, whose disks move together; of independent disks if the
  /// scene requests an accuracy of <V_x>.
  bool keepsSeries() const { return layer_ || hasGroups(); }

  /// @param block_time of the original blocks [s]
  MeanSeries series(double block_time) const;

  /// @throws StateError if the state lacks a series that the scene requests; other series are discarded
  void archive(StateArchive& state);

private:
  /// Sums over the trajectories of one species, size class or group.
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

    SpeciesMeans means(const SpeciesDefinition& species) const;
  };

  bool hasGroups() const { return first_group_ < species_of_.size(); }
  BlockSum pathOf(std::uint32_t slot, double time) const;
  template <typename Function>
  void eachRow(std::uint32_t slot, const Function& function) const;
  void add(std::uint32_t slot, double time, std::vector<Sums>& sums) const;
  std::vector<BlockSum> paths(double time) const;
  std::vector<Sums> sums(double time) const;
  SpeciesMeans meansOf(std::size_t row, const std::vector<Sums>& sums) const;

  const SystemState& system_;
  bool layer_;                           ///< whether disks collide with each other
  std::vector<std::size_t> species_of_;  ///< of each row: species, size classes, and groups if requested
  std::size_t first_group_;              ///< its row
  std::vector<Sums> gone_;               ///< of closed paths

  // The series: of a layer, else of the groups.
  std::vector<BlockSum> at_block_end_;  ///< at the end of the last block
  std::vector<BlockAverages> blocks_;
};

}  // namespace ratchet_sieve
