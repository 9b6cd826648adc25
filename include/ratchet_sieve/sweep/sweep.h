#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ratchet_sieve/sweep/axis.h"

namespace ratchet_sieve
{

/// Seeds first, first + 1, ...
struct SeedRange
{
  std::uint64_t first = 0;
  std::uint64_t count = 0;  ///< 0: the scene's own alone
};

/// Many runs of one scene: the product of a grid, of values side by side, of cases listed one by one, and of
/// seeds. Nothing of the product is kept: its cases are worked out one by one.
class Sweep
{
public:
  std::string source;             ///< the file that it was read from, for errors
  std::string scene_text;         ///< YAML
  std::string scene_source;       ///< where that is from, for errors
  std::vector<Assignment> fixed;  ///< set in every case
  std::vector<Axis> axes;         ///< the last one varies fastest
  SeedRange seeds;                ///< vary faster still

  /// Settings, seeds aside.
  std::uint64_t points() const;

  std::uint64_t size() const { return points() * seedCount(); }
  std::uint64_t seedCount() const { return seeds.count > 0 ? seeds.count : 1; }

  /// Every key that is swept, in the order of the file.
  std::vector<std::string> keys() const;

  /// What a setting sets, beyond `fixed`. @pre point < points()
  std::vector<Assignment> point(std::uint64_t point) const;

  /// 16 hexadecimal digits: the same for the same sweep of the same scene by the same version of the program.
  std::string fingerprint() const;
};

/// Most cases that a sweep may have.
constexpr std::uint64_t MOST_CASES = 1'000'000'000'000'000;

/// Reads a sweep's file, and that of its scene, whose path is relative to it.
/// @throws SceneError where it is no sweep; its cases are not looked at
Sweep loadSweep(const std::string& path);

}  // namespace ratchet_sieve
