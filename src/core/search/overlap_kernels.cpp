#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "model/lane_limit.h"
#include "search/overlap_rows.h"

namespace ratchet_sieve
{
namespace
{

/// Bit k: whether the row overlaps the k-th of four from `at` on.
unsigned overlapsOfFour(const OverlapRows& rows, std::uint32_t row, std::uint32_t at)
{
#if defined(__SSE2__)
  const __m128 ds = _mm_sub_ps(_mm_loadu_ps(rows.s + at), _mm_set1_ps(rows.s[row]));
  const __m128 dn = _mm_sub_ps(_mm_loadu_ps(rows.n + at), _mm_set1_ps(rows.n[row]));
  const __m128 reach = _mm_add_ps(_mm_loadu_ps(rows.radius + at), _mm_set1_ps(rows.radius[row]));
  const __m128 distance_squared = _mm_add_ps(_mm_mul_ps(ds, ds), _mm_mul_ps(dn, dn));
  return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(distance_squared, _mm_mul_ps(reach, reach))));
#else
  unsigned found = 0;
  for (unsigned k = 0; k < 4; ++k)
  {
    const float ds = rows.s[at + k] - rows.s[row];
    const float dn = rows.n[at + k] - rows.n[row];
    const float reach = rows.radius[at + k] + rows.radius[row];
    found |= (ds * ds + dn * dn < reach * reach ? 1U : 0U) << k;
  }
  return found;
#endif
}

std::size_t overlaps(const OverlapRows& rows, std::uint32_t row, std::uint32_t begin, std::uint32_t end,
                     OverlapHits hits)
{
  std::size_t count = 0;
  for (std::uint32_t at = begin; at < end; at += 4)
    for (unsigned found = overlapsOfFour(rows, row, at); found != 0; found &= found - 1)
    {
      const std::uint32_t other = at + static_cast<std::uint32_t>(__builtin_ctz(found));
      hits.first[count] = row;
      hits.second[count] = other;
      count += other < end && other != row ? 1 : 0;
    }
  return count;
}

}  // namespace

const OverlapKernel OVERLAPS_OF_FOUR_LANES = overlaps;

OverlapKernel overlapKernel(int lanes)
{
#if defined(__x86_64__)
  if (lanes == 16)
    return __builtin_cpu_supports("avx512f") ? OVERLAPS_OF_SIXTEEN_LANES : nullptr;
#endif
  return lanes == 4 ? OVERLAPS_OF_FOUR_LANES : nullptr;
}

OverlapKernel widestOverlapKernel()
{
  // Single precision: twice as many values per register.
  const OverlapKernel wide = laneLimit() == 8 ? overlapKernel(16) : nullptr;
  return wide != nullptr ? wide : OVERLAPS_OF_FOUR_LANES;
}

}  // namespace ratchet_sieve
