#include "simd/batch_kernels.h"

namespace ratchet_sieve
{
namespace
{
#define LANES 1
#include "simd/batch_kernel.inc"
}  // namespace

const BatchKernel KERNEL_OF_ONE_LANE{LANES, collide, search, launch};
}  // namespace ratchet_sieve
