#define LANES 8
#define KERNEL KERNEL_OF_EIGHT_LANES
#include "simd/batch_kernel.inc"
