#pragma once

#include <cstdint>
#include <vector>

#include "ratchet_sieve/core/mean_series.h"
#include "state/observer.h"

namespace ratchet_sieve
{

class SystemState;

/// The series behind the errors of a run, besides those of a layer: <V_x> of groups of independent disks, if
/// the scene requests an accuracy of it; the exits of disks of a machine with a feed. Times are local to the
/// epoch.
class AccuracySeries final : public Observer
{
public:
  /// @param system outlives this
  explicit AccuracySeries(const SystemState& system);

  /// Whether anything is recorded.
  bool kept() const { return !groups_.empty() || !exits_.empty(); }

  void compact(const Compaction& compaction) override;
  void restart(double time) override;
  void endBlock(double time) override;

  /// Samples per block of <V_x>; 1 if none is recorded.
  std::size_t blockLength() const { return groups_.empty() ? 1 : groups_.front().blockLength(); }

  /// Adds the recorded series to those of each species.
  void addTo(MeanSeries& series) const;

  /// @throws StateError if the state lacks a series that the scene requests; other series are discarded
  void archive(StateArchive& state) override;

private:
  std::size_t row(std::uint32_t slot) const;
  void addTrajectory(std::uint32_t slot, double x, double until, std::vector<BlockSum>& sums) const;
  void endGroups(double time);
  void endExits();

  const SystemState& system_;
  std::vector<BlockSum> gone_;          ///< per row (a group of a species): of disks removed by compaction
  std::vector<BlockSum> at_block_end_;  ///< per row, at the end of the last block
  std::vector<BlockAverages> groups_;   ///< per row
  std::vector<BlockSum> exited_;        ///< per species, at the end of the last block
  std::vector<BlockAverages> exits_;    ///< per species
};

}  // namespace ratchet_sieve
