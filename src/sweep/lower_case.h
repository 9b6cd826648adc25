#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace ratchet_sieve
{

/// A text with its ASCII letters in lower case: SQL compares the names of columns so.
inline std::string lowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

}  // namespace ratchet_sieve
