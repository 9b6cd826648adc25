#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// The node that advertised a topic before this one, and publishes it still; nothing if there is none. Of two
/// nodes that advertise a topic and then ask this, however close together, exactly one gets the other's name.
///
/// The master names publishers in the order in which they came. Each is asked whether it publishes the topic:
/// what a killed node has left in the master's books does not answer, or another answers in its place.
/// @pre this node has advertised the topic @param topic resolved
std::optional<std::string> earlierPublisher(const std::string& topic);

}  // namespace ratchet_sieve
