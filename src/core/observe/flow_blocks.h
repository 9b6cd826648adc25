#pragma once

#include <vector>

#include "observe/bins.h"
#include "ratchet_sieve/statistics/flow_series.h"
#include "ratchet_sieve/statistics/segregation.h"
#include "state/observer.h"

namespace ratchet_sieve
{

/// Records a FlowSeries. It reads the bins at the end of each block: a departure costs nothing more.
class FlowBlocks final : public Observer
{
public:
  /// @param bins outlive this
  explicit FlowBlocks(const Bins& bins);

  unsigned subscriptions() const override { return BLOCKS; }
  void restart(double time) override;
  void endBlock(double time) override;

  /// @param start of the first block, in the run's time [s] @param block_time of the original blocks [s]
  FlowSeries series(double start, double block_time) const;

  /// @throws StateError if the state is of another number of species
  void archive(StateArchive& state) override;

private:
  /// Of one bin of one species.
  struct Bin
  {
    BlockAverages number;
    BlockAverages mass;

    void archive(StateArchive& state) { state(number, mass); }
  };

  /// Of one species. A block's weight is the number of original blocks.
  struct Row
  {
    Bin left;
    Bin right;
    BlockAverages inside;
    SpeciesBins before;  ///< at the end of the last block

    void archive(StateArchive& state) { state(left, right, inside, before); }
  };

  const Bins& bins_;
  std::vector<Row> rows_;  ///< per species
};

}  // namespace ratchet_sieve
