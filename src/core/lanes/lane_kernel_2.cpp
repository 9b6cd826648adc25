#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "lanes/lane_kernels.h"

namespace ratchet_sieve
{
namespace
{
#define LANES 2
#include "lanes/lane_kernel.inc"
}  // namespace

const LaneKernel KERNEL_OF_TWO_LANES{LANES, collide, search, launch};
}  // namespace ratchet_sieve
