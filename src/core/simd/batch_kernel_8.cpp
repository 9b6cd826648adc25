#include <cstddef>
#include <cstdint>

#if defined(__x86_64__)
// gcc's own header deliberately leaves a register undefined, and warns of it.
#if !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <immintrin.h>

// Applies to the code below, including the physics, but not to the headers above.
#if defined(__clang__)
#pragma clang attribute push(__attribute__((target("avx512f,avx512vl"))), apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512vl")
#endif

#include "model/motion.h"
#include "simd/simd_batch.h"

namespace ratchet_sieve
{
namespace
{
#define LANES 8
#include "simd/batch_kernel.inc"
}  // namespace

const BatchKernel KERNEL_OF_EIGHT_LANES{LANES, collide, search};
}  // namespace ratchet_sieve

#if defined(__clang__)
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#endif
