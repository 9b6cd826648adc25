#pragma once

#include <locale>
#include <optional>
#include <sstream>
#include <string>

namespace ratchet_sieve
{

/// The whole text as a number, in every locale the same; nothing if it is none that the type can hold. A
/// double is finite, and there is one zero: -0.0 would be another setting with another hash.
template <typename Number>
std::optional<Number> parsed(const std::string& text)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Number value{};
  if (text.empty() || !(stream >> value) || stream.peek() != std::istringstream::traits_type::eof())
    return std::nullopt;
  return value + Number{};
}

}  // namespace ratchet_sieve
