#pragma once

#include "model/motion.h"
#include "simd/simd_batch.h"

/// The available kernels. Each is compiled for its own register width, together with the physics included
/// here.
namespace ratchet_sieve
{
extern const BatchKernel KERNEL_OF_TWO_LANES;
#if defined(__x86_64__)
extern const BatchKernel KERNEL_OF_FOUR_LANES;
extern const BatchKernel KERNEL_OF_EIGHT_LANES;
#endif
}  // namespace ratchet_sieve
