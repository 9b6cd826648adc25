#pragma once

#include "ratchet_sieve/core/lane_batch.h"

/// The kernels that there are: each is compiled for its own width of register.
namespace ratchet_sieve
{
extern const LaneKernel KERNEL_OF_ONE_LANE;
extern const LaneKernel KERNEL_OF_TWO_LANES;
#if defined(__x86_64__)
extern const LaneKernel KERNEL_OF_FOUR_LANES;
extern const LaneKernel KERNEL_OF_EIGHT_LANES;
#endif
}  // namespace ratchet_sieve
