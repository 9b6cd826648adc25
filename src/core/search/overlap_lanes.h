#pragma once

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace ratchet_sieve
{

/// One disk against several others side by side.
struct OverlapLanes
{
  /// How many others.
  static constexpr unsigned COUNT = 16;

  struct Disk
  {
    float s;
    float n;
    float radius;
  };

  /// Bit k: whether the disk overlaps the other whose position and radius are (s[k], n[k]) and radius[k].
  static unsigned overlaps(const Disk& disk, const float* s, const float* n, const float* radius)
  {
    unsigned found = 0;
#if defined(__SSE2__)
    const __m128 at_s = _mm_set1_ps(disk.s);
    const __m128 at_n = _mm_set1_ps(disk.n);
    const __m128 reach = _mm_set1_ps(disk.radius);
    for (unsigned k = 0; k < COUNT; k += 4)
    {
      const __m128 ds = _mm_sub_ps(_mm_loadu_ps(s + k), at_s);
      const __m128 dn = _mm_sub_ps(_mm_loadu_ps(n + k), at_n);
      const __m128 apart = _mm_add_ps(_mm_loadu_ps(radius + k), reach);
      const __m128 near = _mm_cmplt_ps(_mm_add_ps(_mm_mul_ps(ds, ds), _mm_mul_ps(dn, dn)), _mm_mul_ps(apart, apart));
      found |= static_cast<unsigned>(_mm_movemask_ps(near)) << k;
    }
#else
    for (unsigned k = 0; k < COUNT; ++k)
    {
      const float ds = s[k] - disk.s;
      const float dn = n[k] - disk.n;
      const float apart = radius[k] + disk.radius;
      found |= (ds * ds + dn * dn < apart * apart ? 1U : 0U) << k;
    }
#endif
    return found;
  }
};

}  // namespace ratchet_sieve
