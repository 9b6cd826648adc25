#pragma once

#include <cstring>
#include <type_traits>

#include "ratchet_sieve/core/fields.h"

namespace ratchet_sieve
{

/// Bitwise equality of frames and their members: -0 differs from 0, and a NaN equals itself.
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

}  // namespace ratchet_sieve
