#pragma once

#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/mean_series.h"
#include "state/machine_state.h"

namespace ratchet_sieve
{

/// The series that only a scene which asks for a certainty needs (AccuracyDefinition): <V_x> of groups of
/// disks that do not see each other, and which way the disks of a fed machine leave. Times are local to the
/// epoch.
class AccuracySeries
{
public:
  /// @param machine outlives this
  explicit AccuracySeries(const MachineState& machine);

  /// Whether there is anything to be kept.
  bool kept() const { return !groups_.empty() || !exits_.empty(); }

  /// Sums up the passages of disks that are about to be compacted away.
  void forget(const std::vector<std::uint32_t>& left);

  /// Forgets all that was counted before.
  void restart();
  void endBlock(double time);

  /// Samples to a block of <V_x>; 1 where none is kept.
  std::size_t blockLength() const { return groups_.empty() ? 1 : groups_.front().blockLength(); }

  /// Adds what is kept to the series of each species.
  void addTo(MeanSeries& series) const;

  /// @throws StateError where the state lacks what the scene asks for; what it does not ask for is dropped
  void archive(StateArchive& state);

private:
  std::size_t row(std::uint32_t slot) const;
  void addPassage(std::uint32_t slot, double x, double until, std::vector<BlockSum>& sums) const;
  void endGroups(double time);
  void endExits();

  const MachineState& machine_;
  std::vector<BlockSum> gone_;          ///< per row: a group of a species; of disks that were compacted away
  std::vector<BlockSum> at_block_end_;  ///< per row, when the last block ended
  std::vector<BlockAverages> groups_;   ///< per row
  std::vector<BlockSum> exited_;        ///< per species, when the last block ended
  std::vector<BlockAverages> exits_;    ///< per species
};

}  // namespace ratchet_sieve
