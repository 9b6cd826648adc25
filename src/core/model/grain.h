#pragma once

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The properties of one disk that never change, besides its species and its radius, which the searches read
/// in Disk.
struct Grain
{
  double mass = 0.0;  ///< [kg]

  void archive(StateArchive& state) { state(mass); }
};

/// The grain of a disk of this species and radius [m].
inline Grain grainOf(const SpeciesDefinition& species, double radius)
{
  return {species.massOf(radius)};
}

}  // namespace ratchet_sieve
