#pragma once

#include <string>

namespace ratchet_sieve
{

/// Goes through a bag once and sees to it that every length, position and count in it holds, before
/// rosbag reads it, which trusts them all: else a damaged bag makes it read beyond its memory, claim
/// gigabytes or never end. What a bag unpacks to is bounded by its size.
/// @throws BagError where the bag is none of format 2.0, encrypted, not closed, or damaged
void requireSoundBag(const std::string& path);

/// Whether a file says that it is a bag with an index: one that was closed, or that was reindexed.
bool isIndexedBag(const std::string& path);

}  // namespace ratchet_sieve
