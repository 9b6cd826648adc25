#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace ratchet_sieve
{

/// A key of the scene, as a dotted path, and its new value, as YAML text on one line.
struct Assignment
{
  std::string key;
  std::string value;
};

/// One factor of a sweep's product of values.
struct Axis
{
  std::string place;  ///< in the sweep file: `grid`, `zip` or `cases`
  std::vector<std::string> keys;
  std::uint64_t size = 0;
  std::function<std::vector<Assignment>(std::uint64_t)> at;  ///< the assignments of one step along the axis
  std::string text;                                          ///< its source text, on one line
};

/// A node's YAML text on one line; parsing it gives the same node. @pre the node does not contain itself
std::string flowText(const YAML::Node& node);

/// `from + (to - from) k / (count - 1)`, rounded to 15 digits: 0.3 stays 0.3, and a coarser range has exactly
/// the values of a finer one where they coincide. @pre k < count
double rangeValue(double from, double to, std::uint64_t count, std::uint64_t k);

/// Seeds first, first + 1, ..., or those that are listed.
struct Seeds
{
  std::uint64_t first = 0;
  std::uint64_t count = 0;  ///< 0: only the scene's own seed
  std::vector<std::uint64_t> listed;

  /// @pre k < count
  std::uint64_t at(std::uint64_t k) const { return listed.empty() ? first + k : listed[k]; }
};

/// One of several parts of a sweep, for instance for one machine. A case's part depends on its position
/// alone: part 1 of 3 has the positions 0, 3, 6, ..., so that all parts take about as long.
struct SweepPart
{
  std::uint64_t number = 1;  ///< from 1
  std::uint64_t count = 1;
};

/// Many runs of one scene: the product of a grid, of lists stepped through together, of listed cases, and of
/// seeds. The product is never stored; its cases are built one by one.
class Sweep
{
public:
  std::string source;             ///< its file, for error messages
  std::string scene_text;         ///< YAML
  std::string scene_source;       ///< its file, for error messages
  bool scene_is_inside = false;   ///< in the sweep's own file
  std::vector<Assignment> fixed;  ///< set in every case
  std::vector<Axis> axes;         ///< the last one varies fastest
  Seeds seeds;                    ///< vary fastest of all
  SweepPart part;                 ///< of which the cases are run

  /// Number of settings, without seeds.
  std::uint64_t points() const;

  std::uint64_t size() const { return points() * seedCount(); }
  std::uint64_t sizeOfPart() const { return (size() + part.count - part.number) / part.count; }
  std::uint64_t seedCount() const { return seeds.count > 0 ? seeds.count : 1; }

  /// All swept keys but `seed`, in the order of the file.
  std::vector<std::string> keys() const;

  /// The assignments of a setting, without `fixed`. @pre point < points()
  std::vector<Assignment> point(std::uint64_t point) const;

  /// What feed.file names in any case, read or not.
  std::set<std::string> feedFiles() const;

  /// 16 hexadecimal digits that identify the sweep, its part, its scene and the version of the physics.
  std::string fingerprint() const;
};

/// Largest number of cases in a sweep.
constexpr std::uint64_t MOST_CASES = 1'000'000'000'000'000;

/// Reads a sweep file and its scene file, whose path is relative to the sweep file.
/// @throws SceneError if the sweep is illegal; the cases are not checked
Sweep loadSweep(const std::string& path);

/// Reads the text of a sweep file. @param source named in errors; the path of the scene is relative to it
Sweep sweepFromText(const std::string& text, const std::string& source);

}  // namespace ratchet_sieve
