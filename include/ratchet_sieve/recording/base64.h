#pragma once

#include <string>

namespace ratchet_sieve
{

/// RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace ratchet_sieve
