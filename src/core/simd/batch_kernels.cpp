#include "simd/simd_batch.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ratchet_sieve
{

int laneLimit()
{
  constexpr const char* VARIABLE = "RATCHET_SIEVE_LANES";
  const char* text = std::getenv(VARIABLE);
  if (text == nullptr)
    return 8;
  for (const int lanes : {2, 4, 8})
    if (std::to_string(lanes) == text)
      return lanes;
  throw std::invalid_argument(std::string("environment variable ") + VARIABLE + " = " + text +
                              ": must be 2, 4 or 8");
}

const BatchKernel& widestKernel([[maybe_unused]] int most_lanes)
{
#if defined(__x86_64__)
  if (most_lanes >= 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl"))
    return KERNEL_OF_EIGHT_LANES;
  if (most_lanes >= 4 && __builtin_cpu_supports("avx2"))
    return KERNEL_OF_FOUR_LANES;
#endif
  return KERNEL_OF_TWO_LANES;
}

}  // namespace ratchet_sieve
