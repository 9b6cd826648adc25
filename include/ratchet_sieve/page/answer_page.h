#pragma once

#include <string>

namespace ratchet_sieve
{

/// One HTML file that shows the answer of a search: python/ratchet_sieve/answers/page.py.
/// @param answer JSON
std::string answerPage(const std::string& answer);

}  // namespace ratchet_sieve
