#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "model/motion.h"
#include "simd/simd_batch.h"

namespace ratchet_sieve
{
namespace
{
#define LANES 2
#include "simd/batch_kernel.inc"
}  // namespace

const BatchKernel KERNEL_OF_TWO_LANES{LANES, collide, search};
}  // namespace ratchet_sieve
