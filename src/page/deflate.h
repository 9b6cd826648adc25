#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ratchet_sieve
{

/// In zlib's format (RFC 1950), which browsers call "deflate".
std::string deflated(const std::string& bytes);

/// Integers as bytes that compress well: small numbers of either sign give small numbers (zigzag: 0, -1, 1,
/// -2, ...); then the lowest bytes of all, then the next, four of each.
std::string bytePlanes(const std::vector<std::int32_t>& numbers);

/// The same of the bytes of doubles, eight of each, unchanged.
std::string bytePlanes(const std::vector<double>& numbers);

}  // namespace ratchet_sieve
