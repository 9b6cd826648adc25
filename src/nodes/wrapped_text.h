#pragma once

#include <cstddef>
#include <string>

namespace ratchet_sieve
{

/// Longest line of help and tables [characters].
constexpr std::size_t TEXT_WIDTH = 110;

/// Lines of at most TEXT_WIDTH characters, each indented.
inline std::string wrappedText(const std::string& text, std::size_t indent)
{
  std::string lines;
  std::size_t begin = 0;
  while (begin < text.size())
  {
    std::size_t end = text.size();
    if (end - begin > TEXT_WIDTH - indent)
      end = text.rfind(' ', begin + TEXT_WIDTH - indent);
    if (end == std::string::npos || end <= begin)
      end = text.size();
    lines += std::string(indent, ' ') + text.substr(begin, end - begin) + "\n";
    begin = end + 1;
  }
  return lines;
}

}  // namespace ratchet_sieve
