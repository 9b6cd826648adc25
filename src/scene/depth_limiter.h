#pragma once

#include <string>

namespace ratchet_sieve
{

/// Deepest nesting of lists and maps that any scene could want.
constexpr int DEEPEST_NESTING = 16;

/// Whether a text may name a part of itself again (*name). What reads a scene by its schema may be given
/// that; what copies a tree would copy it without end where a part holds itself, or grow without bound.
enum class Aliases
{
  ALLOWED,
  REFUSED
};

/// Reads the text without keeping anything of it, before it is built into a tree: a few bytes can
/// nest so deeply that a recursive reader runs out of stack.
/// @throws YAML::ParserException if it nests deeper, holds a second document or an alias that is refused,
/// or is not YAML
void requireShallow(const std::string& text, Aliases aliases);

}  // namespace ratchet_sieve
