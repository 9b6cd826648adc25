#pragma once

#include <cstddef>
#include <cstdint>

namespace ratchet_sieve
{

/// Positions of disks side by side, as an overlap kernel reads them, one register at a time. Up to MOST_LANES
/// values after the last row are read as well, and ignored.
struct OverlapRows
{
  static constexpr std::size_t MOST_LANES = 16;

  const float* s;
  const float* n;
  const float* radius;
};

/// Two rows that overlap.
struct OverlapHits
{
  std::uint32_t* first;
  std::uint32_t* second;
};

/// Tests a row against the rows in [begin, end), except itself, and stores those that overlap, in increasing
/// order.
/// @param hits has room for MOST_LANES more than are found
/// @return their number
using OverlapKernel = std::size_t (*)(const OverlapRows& rows, std::uint32_t row, std::uint32_t begin,
                                      std::uint32_t end, OverlapHits hits);

extern const OverlapKernel OVERLAPS_OF_FOUR_LANES;
#if defined(__x86_64__)
extern const OverlapKernel OVERLAPS_OF_SIXTEEN_LANES;
#endif

/// The kernel with this number of lanes: 4, or 16 if the processor supports it; otherwise nullptr.
OverlapKernel overlapKernel(int lanes);

/// The kernel for the widest registers of this processor, up to laneLimit(). All give the same hits.
/// @throws std::invalid_argument as laneLimit()
OverlapKernel widestOverlapKernel();

}  // namespace ratchet_sieve
