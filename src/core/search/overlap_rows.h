#pragma once

#include <cstddef>
#include <cstdint>

namespace ratchet_sieve
{

/// Disks side by side, as an overlap kernel reads them: as many at a time as a register holds. Up to
/// MOST_LANES values behind the last row are read, too, and count for nothing.
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

/// Tests the row against those in [begin, end), but not against itself, and writes down those that overlap,
/// rising.
/// @param hits has room for MOST_LANES more than are found
/// @return how many
using OverlapKernel = std::size_t (*)(const OverlapRows& rows, std::uint32_t row, std::uint32_t begin,
                                      std::uint32_t end, OverlapHits hits);

extern const OverlapKernel OVERLAPS_OF_FOUR_LANES;
#if defined(__x86_64__)
extern const OverlapKernel OVERLAPS_OF_SIXTEEN_LANES;
#endif

/// By registers of so many lanes: 4, or 16 on a processor that has them. Else nullptr.
OverlapKernel overlapKernel(int lanes);

/// By the widest registers that this processor has. All give the same hits.
OverlapKernel widestOverlapKernel();

}  // namespace ratchet_sieve
