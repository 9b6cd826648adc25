#pragma once

#include <string>

namespace ratchet_sieve
{

/// The frame that all sieves share: x to the right, z up (y of the plane).
constexpr const char* WORLD_FRAME_ID = "world";

/// The mount of the base: origin at the base's foot at s = 0 in its mean position, axes turned by the
/// inclination. It does not follow the drive.
constexpr const char* MOUNT_FRAME_ID = "sieve_mount";

/// The base itself: x along it (s), z normal to it (n).
constexpr const char* BASE_FRAME_ID = "sieve_base";

/// The world frame of a sieve that is mounted elsewhere in `world`.
constexpr const char* OWN_WORLD_FRAME_ID = "sieve_world";

/// The names of the frames of one sieve.
struct FrameNames
{
  std::string world = WORLD_FRAME_ID;  ///< of every message; origin at the base's foot
  std::string mount = MOUNT_FRAME_ID;
  std::string base = BASE_FRAME_ID;
};

/// The default of ~frame_prefix: the sieve's name; empty for /sieve.
/// @param sieve name of its node, resolved
std::string defaultFramePrefix(const std::string& sieve);

/// Why `prefix` cannot be the prefix of a frame_id; empty if it can. The empty prefix is allowed.
std::string framePrefixError(const std::string& prefix);

/// @param own_world whether the sieve is mounted elsewhere than in the origin of `world`
FrameNames frameNames(const std::string& prefix, bool own_world);

}  // namespace ratchet_sieve
