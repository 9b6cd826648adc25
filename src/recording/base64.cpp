#include "ratchet_sieve/recording/base64.h"

#include <cstddef>
#include <cstdint>

namespace ratchet_sieve
{

std::string base64(const std::string& bytes)
{
  static constexpr char LETTERS[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes.size(); k += 3)
  {
    std::uint32_t bits = 0;
    for (std::size_t i = k; i < k + 3; ++i)
      bits = bits << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u);
    const std::size_t letters = bytes.size() - k < 3 ? bytes.size() - k + 1 : 4;
    for (std::size_t i = 0; i < 4; ++i)
      text += i < letters ? LETTERS[(bits >> (18 - 6 * i)) & 0x3f] : '=';
  }
  return text;
}

}  // namespace ratchet_sieve
