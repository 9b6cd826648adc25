#pragma once

#include <cstdint>
#include <string>

namespace ratchet_sieve
{

/// `1 case`, `2 cases`. @param noun in the singular; its plural ends in s
inline std::string countText(std::uint64_t count, const std::string& noun)
{
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

}  // namespace ratchet_sieve
