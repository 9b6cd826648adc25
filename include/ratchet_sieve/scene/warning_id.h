#pragma once

#include <string>

/// The id of a warning's rule stands in brackets at the end of its line, so that warnings can be counted and
/// looked up.
namespace ratchet_sieve
{

inline std::string withId(const std::string& text, const std::string& id)
{
  return text + " [" + id + "]";
}

/// The id of a line, or the whole line if it has none, as those of earlier versions.
inline std::string warningId(const std::string& line)
{
  const std::size_t open = line.rfind(" [");
  return open == std::string::npos || line.back() != ']' ? line
                                                         : line.substr(open + 2, line.size() - open - 3);
}

}  // namespace ratchet_sieve
