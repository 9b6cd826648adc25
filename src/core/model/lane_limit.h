#pragma once

namespace ratchet_sieve
{

/// Largest number of 64-bit values per register: the environment variable RATCHET_SIEVE_LANES (2, 4 or 8),
/// or 8 if it is not set. For tests and bug reports: results do not depend on it.
/// @throws std::invalid_argument if the variable has another value
int laneLimit();

}  // namespace ratchet_sieve
