#pragma once

#include <cmath>
#include <cstddef>
#include <cstring>

#include <Eigen/Core>

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace ratchet_sieve
{

/// Prefetches all cache lines of an object. Affects only the speed.
template <typename T>
void prefetch(const T& object)
{
  constexpr std::size_t LINE = 64;
  const char* const bytes = reinterpret_cast<const char*>(&object);
  for (std::size_t offset = 0; offset < sizeof object; offset += LINE)
    __builtin_prefetch(bytes + offset);
  // Without its own alignment, an object may extend into one more line.
  if (alignof(T) < LINE)
    __builtin_prefetch(bytes + sizeof object - 1);
}

/// Two doubles in one register, available on every 64-bit processor. Operations round as those on single
/// doubles.
using Two = double __attribute__((vector_size(16)));

inline Eigen::Vector2d vectorOf(Two x)
{
  return {x[0], x[1]};
}

/// Of two side by side. @pre aligned as Two
inline Two twoAt(const double* x)
{
  Two two;
  std::memcpy(&two, __builtin_assume_aligned(x, alignof(Two)), sizeof two);
  return two;
}

inline Two twoOf(const Eigen::Vector2d& x)
{
  return twoAt(x.data());
}

/// By one store, as wide as the later load: two stores of 8 bytes before a load of 16 bytes cause a
/// store-forwarding stall.
inline void store(Two x, Eigen::Vector2d& to)
{
  std::memcpy(__builtin_assume_aligned(to.data(), alignof(Eigen::Vector2d)), &x, sizeof x);
}

/// Square roots of the elements, 0 for negative ones.
inline Two rootOrZero(Two x)
{
#if defined(__SSE2__)
  return _mm_sqrt_pd(_mm_max_pd(x, Two{}));
#else
  return Two{std::sqrt(x[0] > 0.0 ? x[0] : 0.0), std::sqrt(x[1] > 0.0 ? x[1] : 0.0)};
#endif
}

/// The smaller of each of the elements. @pre no NaN
inline Two smaller(Two x, Two y)
{
#if defined(__SSE2__)
  return _mm_min_pd(x, y);
#else
  return Two{x[0] < y[0] ? x[0] : y[0], x[1] < y[1] ? x[1] : y[1]};
#endif
}

/// Bit 0 and bit 1: which are less than `limit`.
inline unsigned whichBelow(Two x, double limit)
{
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(_mm_cmplt_pd(x, Two{limit, limit})));
#else
  return (x[0] < limit ? 1U : 0U) | (x[1] < limit ? 2U : 0U);
#endif
}

/// Bit 0 and bit 1: which are no greater than `limit`.
inline unsigned whichUpTo(Two x, double limit)
{
#if defined(__SSE2__)
  return static_cast<unsigned>(_mm_movemask_pd(_mm_cmple_pd(x, Two{limit, limit})));
#else
  return (x[0] <= limit ? 1U : 0U) | (x[1] <= limit ? 2U : 0U);
#endif
}

/// The smallest of sixteen side by side. @pre aligned as Two, no NaN
inline double smallest(const double* sixteen)
{
  const auto four = [&](int i) { return smaller(twoAt(sixteen + i), twoAt(sixteen + i + 2)); };
  const auto eight = [&](int i) { return smaller(four(i), four(i + 4)); };
  const Two least = smaller(eight(0), eight(8));
  return least[0] < least[1] ? least[0] : least[1];
}

/// Bit 0 to bit 15: which of sixteen side by side are no greater than `limit`. @pre aligned as Two
inline unsigned whichUpTo(const double* sixteen, double limit)
{
#if defined(__SSE2__)
  // Each comparison sets all bits or none, so that narrowing keeps the result.
  const __m128d limits = _mm_set1_pd(limit);
  const auto two = [&](int i) { return _mm_castpd_si128(_mm_cmple_pd(_mm_load_pd(sixteen + i), limits)); };
  const auto four = [&](int i) { return _mm_packs_epi32(two(i), two(i + 2)); };
  const auto eight = [&](int i) { return _mm_packs_epi16(four(i), four(i + 4)); };
  return static_cast<unsigned>(_mm_movemask_epi8(_mm_packs_epi16(eight(0), eight(8))));
#else
  unsigned found = 0;
  for (unsigned i = 0; i < 16; ++i)
    found |= (sixteen[i] <= limit ? 1U : 0U) << i;
  return found;
#endif
}

}  // namespace ratchet_sieve
