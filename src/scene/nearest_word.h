#pragma once

#include <set>
#include <string>

namespace ratchet_sieve
{

/// The known word that takes the fewest letters put in, left out or changed to come to `word`
/// (Levenshtein's distance). @pre known is not empty
std::string nearestWord(const std::string& word, const std::set<std::string>& known);

}  // namespace ratchet_sieve
