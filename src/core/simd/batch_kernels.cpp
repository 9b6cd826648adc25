#include "simd/simd_batch.h"

#include <initializer_list>

#include "model/processor.h"

namespace ratchet_sieve
{
namespace
{
const BatchKernel* asked_for = nullptr;

const BatchKernel& widest()
{
  const int limit = laneLimit();
  for (const int lanes : {8, 4})
    if (const BatchKernel* kernel = lanes <= limit ? batchKernel(lanes) : nullptr)
      return *kernel;
  return KERNEL_OF_TWO_LANES;
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
    case 8:
      return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") ? &KERNEL_OF_EIGHT_LANES
                                                                                     : nullptr;
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
