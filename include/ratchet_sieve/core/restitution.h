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

}  // namespace ratchet_sieve
