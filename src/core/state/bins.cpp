#include "state/bins.h"

#include <cmath>

#include "state/system_state.h"

namespace ratchet_sieve
{

Bins::Bins(const SystemState& system) : system_(system), bins_(system.scene().species.size()) {}

void Bins::left(const Departure& departure)
{
  SpeciesBins& bins = bins_[departure.species];
  --bins.on_base;
  const double mass = system_.grain(departure.slot).mass;
  if (departure.exit == Exit::LEFT_BIN)
  {
    ++bins.left;
    bins.left_mass += mass;
  }
  else
  {
    ++bins.right;
    bins.right_mass += mass;
  }
}

void Bins::archive(StateArchive& state)
{
  const std::size_t species = bins_.size();
  state(bins_);
  if (bins_.size() != species)
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
