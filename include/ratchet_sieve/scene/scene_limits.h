#pragma once

namespace ratchet_sieve
{

// The largest values of a scene to which commands and parameters are held as well. They keep products of the
// values far from overflow; no machine comes near them.
constexpr double STEEPEST_INCLINATION = 1.5;  ///< [rad]; short of a base that stands upright
constexpr double LARGEST_AMPLITUDE = 1e3;     ///< [m]
constexpr double LARGEST_FREQUENCY = 1e6;     ///< [Hz]
constexpr double LONGEST_DURATION = 1e9;      ///< [s]

}  // namespace ratchet_sieve
