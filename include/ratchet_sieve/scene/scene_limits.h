#pragma once

namespace ratchet_sieve
{

/// The longest duration of a scene, to which parameters are held as well [s].
constexpr double LONGEST_DURATION = 1e9;

}  // namespace ratchet_sieve
