#pragma once

#include <optional>
#include <set>
#include <string>

namespace ratchet_sieve
{

/// The known word with the least Levenshtein distance to `word`; nothing if the distance is more than half of
/// the length of `word`.
std::optional<std::string> nearestWord(const std::string& word, const std::set<std::string>& known);

}  // namespace ratchet_sieve
