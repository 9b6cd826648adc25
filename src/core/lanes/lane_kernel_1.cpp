#include "lanes/lane_kernels.h"

namespace ratchet_sieve
{
namespace
{
#define LANES 1
#include "lanes/lane_kernel.inc"
}  // namespace

const LaneKernel KERNEL_OF_ONE_LANE{LANES, collide, search, launch};
}  // namespace ratchet_sieve
