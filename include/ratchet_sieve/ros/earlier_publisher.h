#pragma once

#include <optional>
#include <string>

namespace ratchet_sieve
{

/// The node that advertised a topic before this one and still publishes it; nothing if there is none. If two
/// nodes advertise a topic and then call this at nearly the same time, exactly one of them gets the other's
/// name.
///
/// The master lists publishers in the order of registration. Each is asked whether it publishes the topic.
/// The entry of a killed node either gets no answer or is answered by another process.
/// @pre this node has advertised the topic @param topic resolved
std::optional<std::string> earlierPublisher(const std::string& topic);

/// Whether a node, asked itself, says that it publishes a topic. Waits up to 2 s for its answer.
/// @param node, topic resolved
bool publishes(const std::string& node, const std::string& topic);

}  // namespace ratchet_sieve
