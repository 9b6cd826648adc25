#include "ratchet_sieve/core/collision_law.h"

#include <algorithm>
#include <cmath>

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

Impulse collideSmooth(const ContactCoefficients& coefficients, const ContactMasses& masses,
                      double normal_velocity, double min_rebound_speed)
{
  const double rebound_speed = std::max(-coefficients.restitution * normal_velocity, min_rebound_speed);
  return {(rebound_speed - normal_velocity) * masses.normal, 0.0};
}

Impulse collide(const ContactCoefficients& coefficients, const ContactMasses& masses, double normal_velocity,
                double tangential_velocity, double min_rebound_speed)
{
  Impulse impulse = collideSmooth(coefficients, masses, normal_velocity, min_rebound_speed);
  const double sticking =
      (1.0 + coefficients.tangential_restitution) * masses.tangential * std::abs(tangential_velocity);
  const double sliding = coefficients.friction * impulse.normal;
  impulse.tangential = -std::copysign(std::min(sliding, sticking), tangential_velocity);
  return impulse;
}

}  // namespace ratchet_sieve
