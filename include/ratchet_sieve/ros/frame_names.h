#pragma once

#include <string>

namespace ratchet_sieve
{

/// The frame that all sieves share: x to the right, z up (the plane's y).
constexpr const char* WORLD_FRAME_ID = "world";

/// The base's foot at s = 0, at rest, turned with the base: the frame in which the drive is a
/// displacement of the world.
constexpr const char* MOUNT_FRAME_ID = "sieve_mount";

/// The base itself: x along it (s), z normal to it (n).
constexpr const char* BASE_FRAME_ID = "sieve_base";

/// What a sieve that stands elsewhere in the world has in place of `world`.
constexpr const char* OWN_WORLD_FRAME_ID = "sieve_world";

/// The names that the frames of one sieve have.
struct FrameNames
{
  std::string world = WORLD_FRAME_ID;  ///< of every message: its origin is the base's foot
  std::string mount = MOUNT_FRAME_ID;
  std::string base = BASE_FRAME_ID;
};

/// The prefix where no ~frame_prefix says another: the sieve's name, but none for /sieve.
/// @param sieve name of its node, resolved
std::string defaultFramePrefix(const std::string& sieve);

/// Why this is no prefix of a frame's name; empty if it is one. None is a prefix as well.
std::string framePrefixError(const std::string& prefix);

/// @param own_world whether the sieve's origin is another than that of `world`
FrameNames frameNames(const std::string& prefix, bool own_world);

}  // namespace ratchet_sieve
