#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// Default of ~sieve: the sieve in the namespace of the node.
constexpr const char* DEFAULT_SIEVE = "sieve";

/// The name of a sieve, live or played from a bag: the node that publishes a topic of type SceneDescription.
/// If there are several, the first in alphabetical order, with a warning; nothing if there is none.
std::optional<std::string> findSieve();

/// The text of a warning that the scene of a sieve is not received; lists the other sieves.
/// @param sieve name of its node; empty: any
std::string missingSieveText(const std::string& sieve);

}  // namespace ratchet_sieve
