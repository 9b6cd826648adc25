#pragma once

#include <vector>

#include "ratchet_sieve/core/segregation.h"
#include "state/observer.h"

namespace ratchet_sieve
{

class SystemState;

/// The disks and their mass by place: in the machine, and in the bins at its ends. A disk that was removed
/// into no bin stays counted in the machine.
class Bins final : public Observer
{
public:
  /// @param system outlives this
  explicit Bins(const SystemState& system);

  const std::vector<SpeciesBins>& ofSpecies() const { return bins_; }

  Wishes wishes() const override
  {
    Wishes wishes;
    wishes.departures = true;
    return wishes;
  }
  void entered(const Disk& disk) override { ++bins_[disk.species].on_base; }
  void left(const Departure& departure) override;
  void archive(StateArchive& state) override;

private:
  const SystemState& system_;
  std::vector<SpeciesBins> bins_;  ///< per species
};

}  // namespace ratchet_sieve
