#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <string>

namespace ratchet_sieve
{

/// A text from a scene or a bag as errors and reports show it, in one line: control characters become spaces,
/// and a long text is cut.
/// @param longest length that is not cut [characters]
inline std::string shownText(std::string text, std::size_t longest = 60)
{
  constexpr unsigned char DELETE = 0x7f;
  if (text.size() > longest)
    text = text.substr(0, longest) + "...";
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < ' ' || c == DELETE; }, ' ');
  return text;
}

/// `1 case`, `2 cases`. @param noun in the singular; its plural ends in s
inline std::string countText(std::uint64_t count, const std::string& noun)
{
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

/// What a program says of an error that ends it.
inline std::string errorText(const std::exception& error)
{
  if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
    return "not enough memory: fewer disks (species.N.count) or lower frame rates need less";
  return error.what();
}

/// A line with the id of its rule in brackets at the end, so that warnings can be counted and looked up.
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
