#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// The name of a sieve whose topics the master knows, live or played from a bag: that of the node which
/// published the one topic of type SceneDescription. Of several, the first in the order of the alphabet, with
/// a warning; nothing where there is none.
std::optional<std::string> findSieve();

}  // namespace ratchet_sieve
