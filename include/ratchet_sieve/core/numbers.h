#pragma once

/// The arithmetic operations of the physics, which is written once as templates over the number type
/// (motion.h, luding_law.h). This file defines them for a double; pack_pairs.inc defines them for
/// SIMD packs of doubles. Both round alike, so the bits of a result do not depend on the number type.
///
/// These headers include only each other and contain only templates over the number type and functions that
/// are always inlined. Reason: the SIMD kernels compile them for instruction sets that not every processor
/// has. The linker must find no copy of such a function that another translation unit could use.
#define RATCHET_SIEVE_INLINE inline __attribute__((always_inline))

namespace ratchet_sieve
{

RATCHET_SIEVE_INLINE bool less(double a, double b)
{
  return a < b;
}
RATCHET_SIEVE_INLINE bool both(bool a, bool b)
{
  return a & b;
}
RATCHET_SIEVE_INLINE bool either(bool a, bool b)
{
  return a | b;
}
RATCHET_SIEVE_INLINE double select(bool mask, double yes, double no)
{
  return mask ? yes : no;
}
RATCHET_SIEVE_INLINE double root(double a)
{
  return __builtin_sqrt(a);
}
RATCHET_SIEVE_INLINE double absolute(double a)
{
  return __builtin_fabs(a);
}
RATCHET_SIEVE_INLINE double lesser(double a, double b)
{
  return a < b ? a : b;
}
RATCHET_SIEVE_INLINE double greater(double a, double b)
{
  return a > b ? a : b;
}

/// `value` as a number of the same type as `pattern`.
RATCHET_SIEVE_INLINE double like(double /*pattern*/, double value)
{
  return value;
}

/// The nearest integer, |a| < 2^51.
template <typename Number>
RATCHET_SIEVE_INLINE Number rounded(Number a)
{
  constexpr double TO_INTEGER = 6755399441055744.0;  // 1.5 * 2^52: adding it rounds to an integer
  return (a + TO_INTEGER) - TO_INTEGER;
}

/// The largest integer that is not above a, |a| < 2^51.
template <typename Number>
RATCHET_SIEVE_INLINE Number floored(Number a)
{
  const Number nearest = rounded(a);
  return nearest - select(less(a, nearest), like(a, 1.0), like(a, 0.0));
}

}  // namespace ratchet_sieve
