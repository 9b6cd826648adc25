#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Why a file cannot be opened for reading: "no such file", "is a directory" or the system's message; nothing
/// if it can.
std::optional<std::string> whyUnreadable(const std::string& path);

}  // namespace ratchet_sieve
