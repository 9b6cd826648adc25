#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/block_averages.h"
#include "ratchet_sieve/core/observation.h"
#include "state/contact_outcome.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Means over disks and time, from the disks' trajectories: of each species, then of each size class. Times
/// are local to the epoch.
class SpeciesAverages
{
public:
  explicit SpeciesAverages(const SystemState& system);

  /// Adds the trajectories of disks that are about to be removed by compaction.
  void forget(const SystemState& system, const std::vector<std::uint32_t>& left);

  /// Counts a contact of approaching surfaces, for each disk that takes part.
  void take(const ContactOutcome& outcome, const SystemState& system)
  {
    ++contacts_[system.disk(outcome.i).species];
    if (outcome.j != ContactOutcome::BASE)
      ++contacts_[system.disk(outcome.j).species];
  }

  /// Adds contacts counted elsewhere, per species.
  void add(const std::vector<std::uint64_t>& contacts)
  {
    for (std::size_t species = 0; species < contacts.size(); ++species)
      contacts_[species] += contacts[species];
  }

  /// Forgets all counts.
  void restart();

  /// Ends a block of the series for the errors of the means; see BlockAverages.
  void endBlock(const SystemState& system, double time);

  /// Of a species.
  const BlockAverages& blocks(std::size_t species) const { return blocks_[species]; }

  std::vector<SpeciesMeans> means(const SystemState& system, double time) const;

  /// Per size class; without collision rates.
  std::vector<SpeciesMeans> sizeClassMeans(const SystemState& system, double time) const;

  /// @throws StateError
  void archive(StateArchive& state)
  {
    state(gone_, at_block_end_, blocks_, contacts_);
    const std::size_t count = species_of_.size();
    state.require(gone_.size() == count && at_block_end_.size() == count && blocks_.size() == count &&
                      contacts_.size() == species_.size(),
                  "its means have another number of species");
  }

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
  static void add(const SystemState& system, std::uint32_t slot, const Trajectory& trajectory, double x,
                  double until, std::vector<Sums>& sums);
  SpeciesMeans meansOf(std::size_t group, const std::vector<Sums>& sums) const;

  static Weights weights(const SystemState& system, std::uint32_t slot);

  /// Adds the trajectory of a disk that has left, if it counts.
  static void addLeft(const SystemState& system, std::uint32_t slot, std::vector<Sums>& sums);
  std::vector<Sums> sums(const SystemState& system, double time) const;

  std::vector<SpeciesDefinition> species_;
  std::vector<std::size_t> species_of_;  ///< of each group: a species or a size class
  std::vector<Sums> gone_;               ///< per group, of disks removed by compaction
  std::vector<Sums> at_block_end_;       ///< per group, at the end of the last block
  std::vector<BlockAverages> blocks_;    ///< per group
  std::vector<std::uint64_t> contacts_;  ///< per species, since the counting began
};

}  // namespace ratchet_sieve
