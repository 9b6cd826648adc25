#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ratchet_sieve/core/fields.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// What a disk collided with.
enum class CollisionKind
{
  DISK_DISK,
  LEFT_SLOPE,
  RIGHT_SLOPE,
  APEX,  ///< a convex corner of a tooth, or the outermost foot of an open base
  WALL,
  LEVEL  ///< a level face of a tooth, or a flat base
};

/// The name used in summaries and collision files.
inline const char* name(CollisionKind kind)
{
  constexpr const char* NAMES[] = {"disk_disk", "left_slope", "right_slope", "apex", "wall", "level"};
  return NAMES[static_cast<int>(kind)];
}

/// How often each kind of collision happened.
struct CollisionCounts
{
  std::uint64_t disk_disk = 0;
  std::uint64_t left_slope = 0;
  std::uint64_t right_slope = 0;
  std::uint64_t apex = 0;
  std::uint64_t wall = 0;
  std::uint64_t level = 0;

  void add(CollisionKind kind, std::uint64_t times = 1) { this->*OF_KIND[static_cast<int>(kind)] += times; }
  void add(const CollisionCounts& more)
  {
    for (const OfKind of_kind : OF_KIND)
      this->*of_kind += more.*of_kind;
  }
  CollisionCounts since(const CollisionCounts& earlier) const
  {
    CollisionCounts counts;
    for (const OfKind of_kind : OF_KIND)
      counts.*of_kind = this->*of_kind - earlier.*of_kind;
    return counts;
  }
  void archive(StateArchive& state) { state(disk_disk, left_slope, right_slope, apex, wall, level); }

  std::uint64_t total() const { return disk_disk + left_slope + right_slope + apex + wall + level; }

  /// Contacts with the shorter slope over contacts with the longer one (a < 0.5: left over right);
  /// nothing if the longer one was never hit, if the slopes are equally long (a = 0.5) or if a tooth has
  /// more or other faces than two slopes.
  /// @param asymmetry as BaseDefinition::slopeAsymmetry()
  std::optional<double> shortToLong(const std::optional<double>& asymmetry) const
  {
    const std::uint64_t longer = asymmetry && *asymmetry < 0.5 ? right_slope : left_slope;
    if (!asymmetry || *asymmetry == 0.5 || longer == 0)
      return std::nullopt;
    return static_cast<double>(*asymmetry < 0.5 ? left_slope : right_slope) / static_cast<double>(longer);
  }

private:
  using OfKind = std::uint64_t CollisionCounts::*;
  static const OfKind OF_KIND[6];  ///< in the order of CollisionKind
};

inline constexpr CollisionCounts::OfKind CollisionCounts::OF_KIND[] = {
    &CollisionCounts::disk_disk, &CollisionCounts::left_slope, &CollisionCounts::right_slope,
    &CollisionCounts::apex,      &CollisionCounts::wall,       &CollisionCounts::level};

/// Contacts with each part of a profile; both empty for a sawtooth.
struct FaceContacts
{
  std::vector<std::uint64_t> face_contacts;    ///< with the face from corner k of the profile to corner k + 1
  std::vector<std::uint64_t> corner_contacts;  ///< with corner k of the profile; the last corner counts as
                                               ///< corner 0

  void archive(StateArchive& state) { state(face_contacts, corner_contacts); }
};

RATCHET_SIEVE_FIELDS(FaceContacts)
{
  RATCHET_SIEVE_FIELD(face_contacts, "");
  RATCHET_SIEVE_FIELD(corner_contacts, "");
}

RATCHET_SIEVE_FIELDS(CollisionCounts)
{
  RATCHET_SIEVE_FIELD(disk_disk, "");
  RATCHET_SIEVE_FIELD(left_slope, "");
  RATCHET_SIEVE_FIELD(right_slope, "");
  RATCHET_SIEVE_FIELD(apex, "");
  RATCHET_SIEVE_FIELD(wall, "");
  RATCHET_SIEVE_FIELD(level, "");
}

}  // namespace ratchet_sieve
