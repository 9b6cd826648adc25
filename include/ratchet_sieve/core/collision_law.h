#pragma once

#include "ratchet_sieve/core/definition.h"

namespace ratchet_sieve
{

/// What the two partners of a contact bring to the collision law. Masses may be infinite as zero
/// inverse masses: the base.
struct ContactMasses
{
  double normal = 0.0;      ///< m_n, 1/m_n = 1/m_i + 1/m_j [kg]
  double tangential = 0.0;  ///< m_t, 1/m_t = 1/m_n + r_i^2/I_i + r_j^2/I_j [kg]
};

/// @param other nullptr for the base: infinite mass and inertia
ContactMasses contactMasses(const SpeciesDefinition& species, const SpeciesDefinition* other);

struct Impulse
{
  double normal = 0.0;      ///< J_n >= 0, along the normal on disk i [N s]
  double tangential = 0.0;  ///< J_t, along the tangent (normal turned by +90 deg) on disk i [N s]
};

/// The collision law of Luding, Phys. Rev. E 52, 4442 (1995), doi:10.1103/PhysRevE.52.4442, with a
/// floor under the rebound (Farkas et al., Phys. Rev. E 60, 7022 (1999)).
/// @param normal_velocity v_n of the surfaces, < 0: approaching [m/s]
/// @param tangential_velocity v_t of the surfaces at the contact [m/s]
/// @param min_rebound_speed v_min: where e |v_n| falls below it, it is the speed after [m/s]
Impulse collide(const ContactCoefficients& coefficients, const ContactMasses& masses, double normal_velocity,
                double tangential_velocity, double min_rebound_speed);

/// The same without friction: no tangential impulse.
Impulse collideSmooth(const ContactCoefficients& coefficients, const ContactMasses& masses,
                      double normal_velocity, double min_rebound_speed);

/// A contact that loses no energy: e = 1 and smooth. The TC model's, for a contact that follows
/// another within t_c (Luding & McNamara, Granular Matter 1, 113 (1998), doi:10.1007/s100350050017).
constexpr ContactCoefficients LOSSLESS{1.0, 0.0, 0.0};

}  // namespace ratchet_sieve
