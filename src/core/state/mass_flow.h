#pragma once

#include "ratchet_sieve/core/block_averages.h"
#include "state/observable.h"
#include "state/per_bin.h"

namespace ratchet_sieve
{

/// The mass that falls into each bin per time [kg/s], since the end of `settle`. The error of its mean is
/// that of a correlated series (BlockAverages).
class MassFlow final : public Observable
{
public:
  static constexpr const char* NAME = "mass_flow";

  /// @param system outlives this
  explicit MassFlow(const SystemState& system) : system_(system), flows_(system.scene().species.size()) {}

  Wishes wishes() const override
  {
    Wishes wishes;
    wishes.departures = wishes.blocks = true;
    return wishes;
  }
  void left(const Departure& departure) override;
  void restart(double time) override;
  void endBlock(double time) override;
  void archive(StateArchive& state) override { state(flows_, start_, block_start_); }
  Observed observed(double time) const override;

private:
  struct Flow
  {
    double mass = 0.0;      ///< [kg]
    double in_block = 0.0;  ///< of it, in the present block [kg]
    BlockAverages blocks;

    void archive(StateArchive& state) { state(mass, in_block, blocks); }
  };

  double runTime(double time) const { return system_.epoch().start + time; }

  const SystemState& system_;
  PerBin<Flow> flows_;
  double start_ = 0.0;        ///< of the counting, in the run's time [s]
  double block_start_ = 0.0;  ///< in the run's time [s]
};

}  // namespace ratchet_sieve
