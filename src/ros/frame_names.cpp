#include "ratchet_sieve/ros/frame_names.h"

#include <algorithm>

#include <ros/names.h>

namespace ratchet_sieve
{
namespace
{
constexpr const char* UNPREFIXED_SIEVE = "/sieve";

std::string prefixed(const std::string& prefix, const char* frame)
{
  return prefix.empty() ? frame : prefix + "/" + frame;
}
}  // namespace

std::string defaultFramePrefix(const std::string& sieve)
{
  return sieve == UNPREFIXED_SIEVE ? "" : sieve.substr(std::min(sieve.find_first_not_of('/'), sieve.size()));
}

std::string framePrefixError(const std::string& prefix)
{
  std::string error;
  // tf2 refuses a leading slash.
  const bool good = prefix.empty() || (ros::names::validate(prefix, error) && prefix.front() != '/' &&
                                       prefix.front() != '~' && prefix.back() != '/');
  return good ? "" : "must be letters, digits, _ and / between them, beginning with a letter, such as s1";
}

FrameNames frameNames(const std::string& prefix, bool own_world)
{
  return {own_world ? prefixed(prefix, OWN_WORLD_FRAME_ID) : WORLD_FRAME_ID, prefixed(prefix, MOUNT_FRAME_ID),
          prefixed(prefix, BASE_FRAME_ID)};
}

}  // namespace ratchet_sieve
