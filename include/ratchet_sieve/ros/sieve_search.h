#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Where no ~sieve says another: the sieve in the namespace of the node that looks for it.
constexpr const char* DEFAULT_SIEVE = "sieve";

/// The name of a sieve whose topics the master knows, live or played from a bag: that of the node which
/// published the one topic of type SceneDescription. Of several, the first in the order of the alphabet, with
/// a warning; nothing where there is none.
std::optional<std::string> findSieve();

/// What to say where the scene of a sieve does not come: which sieves there are instead.
/// @param sieve name of its node; empty: any
std::string missingSieveText(const std::string& sieve);

/// The node that draws a sieve, of those that publish ~markers and ~cloud; the one named is preferred.
std::optional<std::string> findDisplay(const std::string& preferred);

}  // namespace ratchet_sieve
