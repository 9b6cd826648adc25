#pragma once

#include <string>
#include <type_traits>

#include <fmt/format.h>

#include "ratchet_sieve/recording/same_bits.h"

namespace ratchet_sieve
{

/// The first field in which a frame, or a part of one, differs from the recorded one, with both values.
/// @param name of the part; empty for the whole @pre !sameBits(recorded, now)
template <typename T>
std::string firstDifference(const std::string& name, const T& recorded, const T& now)
{
  if constexpr (IS_DESCRIBED<T>)
  {
    std::string text;
    const auto compare = [&](const FieldInfo& field, const auto& was, const auto& is)
    {
      if (text.empty() && !sameBits(was, is))
        text =
            firstDifference(name.empty() ? field.name : fmt::format("{} of {}", field.name, name), was, is);
    };
    Fields<T>::each(compare, recorded, now);
    return text;
  }
  else if constexpr (IS_VECTOR<T>)
  {
    if (recorded.size() != now.size())
      return fmt::format("{} {} were recorded, {} were computed", recorded.size(), name, now.size());
    std::size_t k = 0;
    while (sameBits(recorded[k], now[k]))
      ++k;
    return firstDifference(fmt::format("{}[{}]", name, k), recorded[k], now[k]);
  }
  else if constexpr (IS_OPTIONAL<T>)
  {
    if (recorded && now)
      return firstDifference(name, *recorded, *now);
    return fmt::format("{} was {}defined, is {}", name, recorded ? "" : "un", now ? "defined" : "undefined");
  }
  else if constexpr (std::is_enum_v<T>)
    return fmt::format("{} was {}, is {}", name, static_cast<int>(recorded), static_cast<int>(now));
  else
    return fmt::format("{} was {}, is {}", name, recorded, now);
}

}  // namespace ratchet_sieve
