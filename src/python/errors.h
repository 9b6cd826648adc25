#pragma once

namespace ratchet_sieve
{

/// Turns the C++ errors of the layers into those of ratchet_sieve.errors.
void translateErrors();

}  // namespace ratchet_sieve
