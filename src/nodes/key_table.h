#pragma once

#include <string>

namespace ratchet_sieve
{

/// The table that `sieve_run --keys` prints: a heading for each part of a scene, two lines for each of its
/// keys. Cells are at least two spaces apart, which no cell contains; docs/scenes.md is made from it.
/// @param part only keys that contain this @return an empty text if there is none
std::string keyTable(const std::string& part);

}  // namespace ratchet_sieve
