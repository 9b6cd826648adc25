#pragma once

#include <string>

namespace ratchet_sieve
{

/// Checks every length, position and count in a bag, in one pass. rosbag trusts them all: a damaged bag makes
/// it read beyond its memory, allocate gigabytes or loop forever. The uncompressed size is limited in
/// proportion to the bag's size.
/// @throws BagError if the file is no bag of format 2.0, or is encrypted, not closed, or damaged
void requireSoundBag(const std::string& path);

/// Whether a file is a bag with an index, according to its header: it was closed, or reindexed.
bool isIndexedBag(const std::string& path);

}  // namespace ratchet_sieve
