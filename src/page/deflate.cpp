#include "deflate.h"

#include <cstring>
#include <stdexcept>

#include <zlib.h>

namespace ratchet_sieve
{

std::string deflated(const std::string& bytes)
{
  uLongf length = compressBound(bytes.size());
  std::string result(length, '\0');
  if (compress2(reinterpret_cast<Bytef*>(result.data()), &length,
                reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::runtime_error("the page could not be compressed");
  result.resize(length);
  return result;
}

namespace
{

/// @param bits of a number, as an unsigned integer
template <typename Number, typename Bits>
std::string planesOf(const std::vector<Number>& numbers, const Bits& bits)
{
  std::string bytes;
  bytes.reserve(sizeof(Number) * numbers.size());
  for (unsigned plane = 0; plane < sizeof(Number); ++plane)
    for (const Number number : numbers)
      bytes += static_cast<char>((bits(number) >> 8U * plane) & 0xFFU);
  return bytes;
}

}  // namespace

std::string bytePlanes(const std::vector<std::int32_t>& numbers)
{
  return planesOf(numbers, [](std::int32_t number)
                  { return (static_cast<std::uint32_t>(number) << 1U) ^ (number < 0 ? 0xFFFFFFFFU : 0U); });
}

std::string bytePlanes(const std::vector<double>& numbers)
{
  return planesOf(numbers,
                  [](double number)
                  {
                    std::uint64_t bits = 0;
                    std::memcpy(&bits, &number, sizeof bits);
                    return bits;
                  });
}

}  // namespace ratchet_sieve
