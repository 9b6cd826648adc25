#pragma once

#include <string>

namespace ratchet_sieve
{

/// Replaces each occurrence of a character by a text.
inline std::string replaced(const std::string& text, char character, const std::string& by)
{
  std::string result;
  for (const char c : text)
    result += c == character ? by : std::string(1, c);
  return result;
}

/// Any text, quoted as one word of a sh command.
inline std::string quotedWord(const std::string& text)
{
  return '\'' + replaced(text, '\'', "'\\''") + '\'';
}

}  // namespace ratchet_sieve
