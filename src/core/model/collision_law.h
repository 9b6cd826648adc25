#pragma once

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/luding_law.h"

namespace ratchet_sieve
{

/// Effective masses of the two partners of a contact. The base has infinite mass: zero inverse masses.
struct ContactMasses
{
  double normal = 0.0;      ///< m_n, 1/m_n = 1/m_i + 1/m_j [kg]
  double tangential = 0.0;  ///< m_t, 1/m_t = 1/m_n + r_i^2/I_i + r_j^2/I_j [kg]
};

/// How a disk resists an impulse at its edge.
struct Inertia
{
  double mass = 0.0;   ///< [kg]
  double lever = 0.0;  ///< 1 + m r^2 / I, the same for all disks of a species: 1 + 1 / alpha
};

inline double leverOf(const SpeciesDefinition& species)
{
  return 1.0 + 1.0 / species.inertia_factor;
}

/// Of a disk and the base.
inline ContactMasses contactMasses(const Inertia& disk)
{
  const double inverse_normal = 1.0 / disk.mass;
  return {1.0 / inverse_normal, 1.0 / (inverse_normal * disk.lever)};
}

/// Of two disks.
inline ContactMasses contactMasses(const Inertia& disk, const Inertia& other)
{
  const double inverse = 1.0 / disk.mass;
  return {1.0 / (inverse + 1.0 / other.mass), 1.0 / (inverse * disk.lever + other.lever / other.mass)};
}

using Impulse = ImpulseOf<double>;

inline ContactNumbers<double> contactNumbers(const ContactCoefficients& coefficients,
                                             const ContactMasses& masses)
{
  return {coefficients.restitution, coefficients.friction, masses.normal,
          (1.0 + coefficients.tangential_restitution) * masses.tangential};
}

/// ludingImpulse() for the coefficients of one contact.
inline Impulse collide(const CollisionLaw& law, const ContactCoefficients& coefficients,
                       const ContactMasses& masses, double normal_velocity, double tangential_velocity)
{
  return ludingImpulse(law, contactNumbers(coefficients, masses), normal_velocity, tangential_velocity);
}

/// A lossless contact: e = 1 and smooth. Used by the TC model for a contact that follows another within t_c
/// (Luding & McNamara, Granular Matter 1, 113 (1998), doi:10.1007/s100350050017).
constexpr ContactCoefficients LOSSLESS{1.0, 0.0, 0.0};

}  // namespace ratchet_sieve
