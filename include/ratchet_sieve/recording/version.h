#pragma once

namespace ratchet_sieve
{

/// The package's version, as every output records it.
const char* version();

}  // namespace ratchet_sieve
