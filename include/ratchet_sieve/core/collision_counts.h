#pragma once

#include <cstdint>
#include <optional>

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
  APEX,  ///< an apex of a tooth, or the outermost foot of an open base
  WALL
};

/// The name used in summaries and collision files: disk_disk, left_slope, right_slope, apex, wall.
const char* name(CollisionKind kind);

/// How often each kind of collision happened.
struct CollisionCounts
{
  std::uint64_t disk_disk = 0;
  std::uint64_t left_slope = 0;
  std::uint64_t right_slope = 0;
  std::uint64_t apex = 0;
  std::uint64_t wall = 0;

  void add(CollisionKind kind, std::uint64_t times = 1) { this->*OF_KIND[static_cast<int>(kind)] += times; }
  void add(const CollisionCounts& more);
  CollisionCounts since(const CollisionCounts& earlier) const;
  void archive(StateArchive& state) { state(disk_disk, left_slope, right_slope, apex, wall); }

  std::uint64_t total() const { return disk_disk + left_slope + right_slope + apex + wall; }

  /// Contacts with the shorter slope over contacts with the longer one (a < 0.5: left over right);
  /// nothing if the longer one was never hit or if the slopes are equally long (a = 0.5).
  std::optional<double> shortToLong(double asymmetry) const;

private:
  using OfKind = std::uint64_t CollisionCounts::*;
  static const OfKind OF_KIND[];  ///< in the order of CollisionKind
};

inline constexpr CollisionCounts::OfKind CollisionCounts::OF_KIND[] = {
    &CollisionCounts::disk_disk, &CollisionCounts::left_slope, &CollisionCounts::right_slope,
    &CollisionCounts::apex, &CollisionCounts::wall};

RATCHET_SIEVE_FIELDS(CollisionCounts)
{
  RATCHET_SIEVE_FIELD(disk_disk, "");
  RATCHET_SIEVE_FIELD(left_slope, "");
  RATCHET_SIEVE_FIELD(right_slope, "");
  RATCHET_SIEVE_FIELD(apex, "");
  RATCHET_SIEVE_FIELD(wall, "");
}

}  // namespace ratchet_sieve
