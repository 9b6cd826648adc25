#pragma once

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The properties of one disk that never change, besides its species and its radius, which the searches read
/// in Disk.
struct Grain
{
  double mass = 0.0;           ///< [kg]
  double spin_response = 0.0;  ///< change of spin by a unit impulse along the rim: r / I [1/(kg m)]

  bool operator==(const Grain& other) const
  {
    return mass == other.mass && spin_response == other.spin_response;
  }
  void archive(StateArchive& state) { state(mass, spin_response); }
};

/// The grain of a disk of this species and radius [m].
inline Grain grainOf(const SpeciesDefinition& species, double radius)
{
  const double mass = species.massOf(radius);
  return {mass, radius / species.inertiaOf(mass, radius)};
}

}  // namespace ratchet_sieve
