#pragma once

#include <string>

namespace ratchet_sieve
{

/// Deepest nesting of lists and maps; no scene needs as much.
constexpr int DEEPEST_NESTING = 16;

/// Whether a text may contain YAML aliases (*name). Code that reads a scene by its schema can handle them.
/// Code that copies a tree cannot: a part that contains itself, or nested aliases, would make it endless or
/// huge.
enum class Aliases
{
  ALLOWED,
  REFUSED
};

/// Checks the text before a tree is built from it: a short text can nest so deeply that a recursive reader
/// runs out of stack.
/// @throws YAML::ParserException if it nests deeper than DEEPEST_NESTING, has a second document or a refused
/// alias, or is not YAML
void requireShallow(const std::string& text, Aliases aliases);

}  // namespace ratchet_sieve
