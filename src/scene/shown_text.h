#pragma once

#include <string>

namespace ratchet_sieve
{

/// A text out of a scene as an error shows it, which has one line: control characters become spaces,
/// and what is very long is cut.
std::string shownText(std::string text);

}  // namespace ratchet_sieve
