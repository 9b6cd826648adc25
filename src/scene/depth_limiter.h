#pragma once

#include <string>

namespace ratchet_sieve
{

/// Deepest nesting of lists and maps that any scene could want.
constexpr int DEEPEST_NESTING = 16;

/// Reads the text without keeping anything of it, before it is built into a tree: a few bytes can
/// nest so deeply that a recursive reader runs out of stack.
/// @throws YAML::ParserException if it nests deeper, holds a second document, or is not YAML
void requireShallow(const std::string& text);

}  // namespace ratchet_sieve
