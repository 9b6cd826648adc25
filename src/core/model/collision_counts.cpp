#include "ratchet_sieve/core/collision_counts.h"

namespace ratchet_sieve
{

const char* name(CollisionKind kind)
{
  switch (kind)
  {
    case CollisionKind::DISK_DISK:
      return "disk_disk";
    case CollisionKind::LEFT_SLOPE:
      return "left_slope";
    case CollisionKind::RIGHT_SLOPE:
      return "right_slope";
    case CollisionKind::APEX:
      return "apex";
    case CollisionKind::WALL:
      return "wall";
    case CollisionKind::LEVEL:
      return "level";
  }
  return "unknown";
}

void CollisionCounts::add(const CollisionCounts& more)
{
  disk_disk += more.disk_disk;
  left_slope += more.left_slope;
  right_slope += more.right_slope;
  apex += more.apex;
  wall += more.wall;
  level += more.level;
}

CollisionCounts CollisionCounts::since(const CollisionCounts& earlier) const
{
  return {disk_disk - earlier.disk_disk,
          left_slope - earlier.left_slope,
          right_slope - earlier.right_slope,
          apex - earlier.apex,
          wall - earlier.wall,
          level - earlier.level};
}

std::optional<double> CollisionCounts::shortToLong(const std::optional<double>& asymmetry) const
{
  if (!asymmetry || *asymmetry == 0.5)
    return std::nullopt;
  const std::uint64_t shorter = *asymmetry < 0.5 ? left_slope : right_slope;
  const std::uint64_t longer = *asymmetry < 0.5 ? right_slope : left_slope;
  if (longer == 0)
    return std::nullopt;
  return static_cast<double>(shorter) / static_cast<double>(longer);
}

}  // namespace ratchet_sieve
