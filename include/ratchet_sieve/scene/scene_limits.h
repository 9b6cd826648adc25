#pragma once

namespace ratchet_sieve
{

/// Longest duration of a scene, and of durations that are ROS parameters [s].
constexpr double LONGEST_DURATION = 1e9;

}  // namespace ratchet_sieve
