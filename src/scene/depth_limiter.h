#pragma once

#include <string>

namespace ratchet_sieve
{

/// Deepest nesting of lists and maps; no scene needs as much.
constexpr int DEEPEST_NESTING = 16;

/// Checks the text before a tree is built from it: a short text can nest so deeply that a recursive reader
/// runs out of stack. Aliases (*name) are refused: an override of one part would change the other as well,
/// and nested ones make a tree huge or endless.
/// @throws YAML::ParserException if it nests deeper than DEEPEST_NESTING, has a second document or an alias,
/// or is not YAML
void requireShallow(const std::string& text);

}  // namespace ratchet_sieve
