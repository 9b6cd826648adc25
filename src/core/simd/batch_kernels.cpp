#include "simd/batch_kernels.h"
#include "model/lane_limit.h"

namespace ratchet_sieve
{
namespace
{
const BatchKernel* asked_for = nullptr;

const BatchKernel& widest()
{
  const BatchKernel* four = laneLimit() >= 4 ? batchKernel(4) : nullptr;
  return four != nullptr ? *four : KERNEL_OF_TWO_LANES;
}
}  // namespace

const BatchKernel* batchKernel(int lanes)
{
  switch (lanes)
  {
    case 2:
      return &KERNEL_OF_TWO_LANES;
#if defined(__x86_64__)
    case 4:
      return __builtin_cpu_supports("avx2") ? &KERNEL_OF_FOUR_LANES : nullptr;
#endif
    default:
      return nullptr;
  }
}

const BatchKernel& presentBatchKernel()
{
  static const BatchKernel& widest_kernel = widest();
  return asked_for ? *asked_for : widest_kernel;
}

bool useLanes(int lanes)
{
  const BatchKernel* kernel = lanes == 0 ? nullptr : batchKernel(lanes);
  if (lanes != 0 && !kernel)
    return false;
  asked_for = kernel;
  return true;
}

}  // namespace ratchet_sieve
