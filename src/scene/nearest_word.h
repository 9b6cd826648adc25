#pragma once

#include <optional>
#include <set>
#include <string>

namespace ratchet_sieve
{

/// The known word that takes the fewest letters put in, left out or changed to come to `word`
/// (Levenshtein's distance); nothing if that is more than half of them.
std::optional<std::string> nearestWord(const std::string& word, const std::set<std::string>& known);

}  // namespace ratchet_sieve
