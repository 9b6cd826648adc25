#pragma once

#include <cstdint>
#include <cstring>

namespace ratchet_sieve
{

inline std::uint64_t bitsOf(double value)
{
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline double doubleOf(std::uint64_t bits)
{
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

struct SineCosine
{
  double sine;
  double cosine;
};

/// sin and cos of 2 pi `turns`, |turns| < 2^50, to within 2 ulp. Our own, so that every machine gives the
/// same bits: the C library picks its kernels by processor. The polynomials are those of FDLIBM (k_sin.c,
/// k_cos.c; Sun Microsystems, 1993) on [-pi/4, pi/4].
inline SineCosine sineCosineOfTurns(double turns)
{
  constexpr double TWO_PI = 6.283185307179586476925;
  constexpr double ROUND_TO_INTEGER = 6755399441055744.0;  // 1.5 * 2^52: adding it leaves no fraction bits
  const double quarters = (turns * 4.0 + ROUND_TO_INTEGER) - ROUND_TO_INTEGER;
  const double z = (turns - quarters * 0.25) * TWO_PI;
  const double zz = z * z;
  const double s =
      z + z * zz *
              (-1.66666666666666324348e-01 +
               zz * (8.33333333332248946124e-03 +
                     zz * (-1.98412698298579493134e-04 +
                           zz * (2.75573137070700676789e-06 +
                                 zz * (-2.50507602534068634195e-08 + zz * 1.58969099521155010221e-10)))));
  const double c =
      1.0 - 0.5 * zz +
      zz * zz *
          (4.16666666666666019037e-02 +
           zz * (-1.38888888888741095749e-03 +
                 zz * (2.48015872894767294178e-05 +
                       zz * (-2.75573143513906633035e-07 +
                             zz * (2.08757232129817482790e-09 + zz * -1.13596475577881948265e-11)))));
  // The quarter decides which is which, and the signs. Nobody can predict it: bits are moved, without a
  // branch.
  const auto quarter = static_cast<std::uint64_t>(static_cast<std::int64_t>(quarters));
  const std::uint64_t swap = 0 - (quarter & 1);
  const std::uint64_t s_bits = bitsOf(s);
  const std::uint64_t c_bits = bitsOf(c);
  const std::uint64_t sine = ((s_bits & ~swap) | (c_bits & swap)) ^ ((quarter & 2) << 62);
  const std::uint64_t cosine = ((c_bits & ~swap) | (s_bits & swap)) ^ (((quarter + 1) & 2) << 62);
  return {doubleOf(sine), doubleOf(cosine)};
}

}  // namespace ratchet_sieve
