#pragma once

#include <vector>

#include "ratchet_sieve/core/segregation.h"
#include "state/observer.h"

namespace ratchet_sieve
{

/// The disks and their mass by place: in the machine, and in the bins at its ends.
class Bins final : public Observer
{
public:
  explicit Bins(std::size_t species) : bins_(species) {}

  const std::vector<SpeciesBins>& ofSpecies() const { return bins_; }

  unsigned subscriptions() const override { return DEPARTURES; }
  void entered(const Disk& disk) override { ++bins_[disk.species].on_base; }
  void left(const Departure& departure) override
  {
    SpeciesBins& bins = bins_[departure.species];
    const bool left = departure.exit == Exit::LEFT_BIN;
    --bins.on_base;
    ++(left ? bins.left : bins.right);
    (left ? bins.left_mass : bins.right_mass) += departure.mass;
  }

  /// @throws StateError if the state is of another number of species
  void archive(StateArchive& state) override
  {
    const std::size_t species = bins_.size();
    state(bins_);
    if (bins_.size() != species)
      throw StateError("it is of another scene");
  }

private:
  std::vector<SpeciesBins> bins_;  ///< per species
};

}  // namespace ratchet_sieve
