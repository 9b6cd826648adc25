#pragma once

#include <cstddef>
#include <string>

namespace ratchet_sieve
{

/// A text from a scene or a bag as errors and reports show it, in one line: control characters become spaces,
/// and a long text is cut.
/// @param longest length that is not cut [characters]
std::string shownText(std::string text, std::size_t longest = 60);

}  // namespace ratchet_sieve
