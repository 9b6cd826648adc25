#define LANES 4
#define KERNEL KERNEL_OF_FOUR_LANES
#include "simd/batch_kernel.inc"
