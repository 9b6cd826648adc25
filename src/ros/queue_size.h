#pragma once

#include <cstdint>

namespace ratchet_sieve
{

/// Queue length of publishers and subscribers. The same as in tf2_ros::TransformBroadcaster: all publishers
/// of a node for one topic share a queue, with the length requested by the first.
constexpr std::uint32_t QUEUE_SIZE = 100;

}  // namespace ratchet_sieve
