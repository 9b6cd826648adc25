#pragma once

#include <cstddef>
#include <string>

namespace ratchet_sieve
{

/// A text out of a scene or a bag as an error or a report shows it, within one line: control characters
/// become spaces, and what is very long is cut.
/// @param longest that is not cut [characters]
std::string shownText(std::string text, std::size_t longest = 60);

}  // namespace ratchet_sieve
