#pragma once

#include <cstring>
#include <type_traits>

#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/recording/frames.h"

namespace ratchet_sieve
{

/// Equality bit for bit, of frames and of all that they consist of: -0 is not 0, and a NaN is itself.
template <typename T>
bool sameBits(const T& a, const T& b)
{
  if constexpr (std::is_floating_point_v<T>)
    return std::memcmp(&a, &b, sizeof a) == 0;  // NOLINT(bugprone-suspicious-memory-comparison): of bits
  else if constexpr (IS_OPTIONAL<T>)
    return a.has_value() == b.has_value() && (!a || sameBits(*a, *b));
  else if constexpr (IS_VECTOR<T>)
  {
    bool same = a.size() == b.size();
    for (std::size_t k = 0; same && k < a.size(); ++k)
      same = sameBits(a[k], b[k]);
    return same;
  }
  else if constexpr (IS_DESCRIBED<T>)
  {
    bool same = true;
    Fields<T>::each(
        [&same](const FieldInfo&, const auto& x, const auto& y) { same = same && sameBits(x, y); }, a, b);
    return same;
  }
  else
    return a == b;
}

/// But for how fast the run went, which the topics and the recording measure each for themselves.
inline bool sameButForSpeed(StatisticsFrame a, StatisticsFrame b)
{
  a.real_time_factor = b.real_time_factor = 0.0;
  return sameBits(a, b);
}

}  // namespace ratchet_sieve
