#include "model/collision_law.h"

namespace ratchet_sieve
{

ContactMasses contactMasses(const SpeciesDefinition& species, const SpeciesDefinition* other)
{
  // r^2 / I = 1 / (alpha m)
  double inverse_normal = 1.0 / species.mass;
  double inverse_tangential = inverse_normal * (1.0 + 1.0 / species.inertia_factor);
  if (other)
  {
    inverse_normal += 1.0 / other->mass;
    inverse_tangential += (1.0 + 1.0 / other->inertia_factor) / other->mass;
  }
  return {1.0 / inverse_normal, 1.0 / inverse_tangential};
}

}  // namespace ratchet_sieve
