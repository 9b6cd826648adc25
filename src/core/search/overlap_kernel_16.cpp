#include <cstddef>
#include <cstdint>

#if defined(__x86_64__)
// gcc's own header deliberately leaves a register undefined, and warns of it.
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>

// Applies to the code below only.
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f")
#endif

#include "search/overlap_rows.h"

namespace ratchet_sieve
{
namespace
{

/// No branch depends on the result: the hits are compressed with SIMD.
std::size_t overlaps(const OverlapRows& rows, std::uint32_t row, std::uint32_t begin, std::uint32_t end,
                     OverlapHits hits)
{
  const __m512 s = _mm512_set1_ps(rows.s[row]);
  const __m512 n = _mm512_set1_ps(rows.n[row]);
  const __m512 radius = _mm512_set1_ps(rows.radius[row]);
  const __m512i itself = _mm512_set1_epi32(static_cast<int>(row));
  const __m512i limit = _mm512_set1_epi32(static_cast<int>(end));
  __m512i others = _mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(begin)),
                                    _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0));
  std::size_t count = 0;
  for (std::uint32_t at = begin; at < end; at += 16)
  {
    const __m512 ds = _mm512_sub_ps(_mm512_loadu_ps(rows.s + at), s);
    const __m512 dn = _mm512_sub_ps(_mm512_loadu_ps(rows.n + at), n);
    const __m512 reach = _mm512_add_ps(_mm512_loadu_ps(rows.radius + at), radius);
    // Separate products, as with four lanes: a fused multiply-add would round differently.
    const __m512 distance_squared = _mm512_add_ps(_mm512_mul_ps(ds, ds), _mm512_mul_ps(dn, dn));
    __mmask16 found = _mm512_cmp_ps_mask(distance_squared, _mm512_mul_ps(reach, reach), _CMP_LT_OQ);
    found = _mm512_mask_cmplt_epi32_mask(found, others, limit);
    found = _mm512_mask_cmpneq_epi32_mask(found, others, itself);
    _mm512_storeu_si512(hits.first + count, itself);
    _mm512_storeu_si512(hits.second + count, _mm512_maskz_compress_epi32(found, others));
    count += static_cast<std::size_t>(__builtin_popcount(found));
    others = _mm512_add_epi32(others, _mm512_set1_epi32(16));
  }
  return count;
}

}  // namespace

const OverlapKernel OVERLAPS_OF_SIXTEEN_LANES = overlaps;
}  // namespace ratchet_sieve

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
