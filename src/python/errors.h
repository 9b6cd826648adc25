#pragma once

#include <string>

namespace ratchet_sieve
{

/// Turns the C++ errors of the layers into those of ratchet_sieve.errors.
void translateErrors();

/// Warns (SieveWarning). @pre Python's lock is held @throws what a filter of warnings makes of it
void warnPython(const std::string& text);

}  // namespace ratchet_sieve
