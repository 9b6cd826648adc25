#pragma once

#include "ratchet_sieve/core/numbers.h"

namespace ratchet_sieve
{

/// x^exponent for 0 <= x <= 1 and 0 <= exponent <= 10, with an error of at most 80 roundings of a double. Own
/// code, because square roots and products round the same on every machine and std::pow does not. Each binary
/// digit 2^-k of the exponent contributes the k-th repeated square root: two of them for 3/4. When the root
/// is close to 1 (at most 710 / 2^18 below it), the binomial series covers the remaining digits.
template <typename Number>
RATCHET_SIEVE_INLINE Number power(Number x, double exponent)
{
  constexpr int MOST_ROOTS = 18;
  Number product = like(x, 1.0);
  double rest = exponent;
  for (; rest >= 1.0; rest -= 1.0)
    product = product * x;
  Number rooted = x;
  for (int digit = 0; digit < MOST_ROOTS && rest > 0.0; ++digit)
  {
    rooted = root(rooted);
    rest = rest + rest;
    if (rest >= 1.0)
    {
      product = product * rooted;
      rest -= 1.0;
    }
  }
  if (rest == 0.0)
    return product;
  const Number t = rooted - like(x, 1.0);
  Number series = like(x, 1.0);
  for (int k = 5; k > 0; --k)
    series = 1.0 + t * ((rest - (k - 1)) / k) * series;
  return product * series;
}

/// Restitution that depends on the speed of the contact: e(v) = 1 - (1 - e) (|v_n| / v_0)^q for |v_n| < v_0,
/// and e above. Bizon et al., Phys. Rev. Lett. 80, 57 (1998), doi:10.1103/PhysRevLett.80.57.
/// @param speed v_0 > 0 [m/s]
/// @param exponent q
template <typename Number>
RATCHET_SIEVE_INLINE Number restitutionBySpeed(Number restitution, Number normal_velocity, double speed,
                                               double exponent)
{
  const Number share = absolute(normal_velocity) / like(normal_velocity, speed);
  const Number slow = 1.0 - (1.0 - restitution) * power(share, exponent);
  return select(less(share, like(share, 1.0)), slow, restitution);
}

/// The parameters of the collision law that hold for all contacts of a scene.
struct CollisionLaw
{
  double min_rebound_speed = 0.05;     ///< v_min [m/s], Farkas et al., Phys. Rev. E 60, 7022 (1999); 0: none
  double restitution_speed = 0.0;      ///< v_0 [m/s], see restitutionBySpeed(); 0: none
  double restitution_exponent = 0.75;  ///< q
};

/// The coefficients and effective masses of a contact of two surfaces.
template <typename Number>
struct ContactNumbers
{
  Number restitution;    ///< e
  Number friction;       ///< Coulomb mu
  Number normal_mass;    ///< m_n [kg]
  Number sticking_mass;  ///< (1 + beta) m_t [kg]
};

template <typename Number>
struct ImpulseOf
{
  Number normal;      ///< J_n >= 0, along the normal on disk i [N s]
  Number tangential;  ///< J_t, along the tangent (normal turned by +90 deg) on disk i [N s]
};

/// The impulse on disk i in the frame of its normal [N s].
template <typename Number>
struct PushOf
{
  Number x;
  Number y;
};

/// @param nx, ny unit normal on disk i
template <typename Number>
RATCHET_SIEVE_INLINE PushOf<Number> pushOf(const ImpulseOf<Number>& impulse, Number nx, Number ny)
{
  return {impulse.normal * nx - impulse.tangential * ny, impulse.normal * ny + impulse.tangential * nx};
}

/// J_n = (v' - v_n) m_n, with the normal speed after the contact v' = max(e |v_n|, v_min). If e depends on
/// the speed, v_min is applied after that dependence.
/// @param normal_velocity v_n of the surfaces, < 0: approaching [m/s]
template <typename Number>
RATCHET_SIEVE_INLINE Number normalImpulse(const CollisionLaw& law, const ContactNumbers<Number>& contact,
                                          Number normal_velocity)
{
  Number restitution = contact.restitution;
  if (law.restitution_speed > 0.0)
    restitution =
        restitutionBySpeed(restitution, normal_velocity, law.restitution_speed, law.restitution_exponent);
  const Number rebound_speed =
      greater(-restitution * normal_velocity, like(normal_velocity, law.min_rebound_speed));
  return (rebound_speed - normal_velocity) * contact.normal_mass;
}

/// The collision law of Luding, Phys. Rev. E 52, 4442 (1995), doi:10.1103/PhysRevE.52.4442: J_t = -sign(v_t)
/// min(mu J_n, (1 + beta) m_t |v_t|), with the minimum rebound speed of normalImpulse().
/// @param tangential_velocity v_t of the surfaces at the contact [m/s]
template <typename Number>
RATCHET_SIEVE_INLINE ImpulseOf<Number> ludingImpulse(const CollisionLaw& law,
                                                     const ContactNumbers<Number>& contact,
                                                     Number normal_velocity, Number tangential_velocity)
{
  const Number normal = normalImpulse(law, contact, normal_velocity);
  const Number sticking = contact.sticking_mass * absolute(tangential_velocity);
  const Number sliding = contact.friction * normal;
  const Number size = lesser(sliding, sticking);
  return {normal, select(less(tangential_velocity, like(size, 0.0)), size, -size)};
}

}  // namespace ratchet_sieve
