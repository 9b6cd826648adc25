#define LANES 2
#define KERNEL KERNEL_OF_TWO_LANES
#include "simd/batch_kernel.inc"
