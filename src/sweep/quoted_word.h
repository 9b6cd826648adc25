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

/// The same, without quotes where sh needs none.
inline std::string plainWord(const std::string& text)
{
  constexpr const char* PLAIN = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_+-=.,:/@%";
  return !text.empty() && text.find_first_not_of(PLAIN) == std::string::npos ? text : quotedWord(text);
}

}  // namespace ratchet_sieve
