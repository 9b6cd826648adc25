#pragma once

#include <vector>

#include "ratchet_sieve/core/segregation.h"
#include "state/observer.h"

namespace ratchet_sieve
{

/// Adds a disk to the bin into which it fell.
inline void count(const Departure& departure, std::vector<SpeciesBins>& bins)
{
  SpeciesBins& of_species = bins[departure.species];
  const bool left = departure.exit == Exit::LEFT_BIN;
  ++(left ? of_species.left : of_species.right);
  (left ? of_species.left_mass : of_species.right_mass) += departure.mass;
}

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
    --bins_[departure.species].on_base;
    count(departure, bins_);
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
