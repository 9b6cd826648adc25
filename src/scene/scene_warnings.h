#pragma once

#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/scene/scalars.h"

/// The texts of warnings about a scene: see implausibilities().
namespace ratchet_sieve
{

constexpr double PI = 3.14159265358979323846;

/// Highest plausible speed of the drive, of disks and of their rims [m/s].
constexpr double FASTEST = 150.0;

/// A number with four significant digits; a larger one is rounded to an integer.
inline std::string number(double value)
{
  std::ostringstream out;
  const bool whole = std::abs(value) >= 1e4 && std::abs(value) < 1e9;
  out.precision(whole ? 0 : 4);
  if (whole)
    out << std::fixed;
  out << value;
  return out.str();
}

inline std::string quantity(double value, const char* unit)
{
  return number(value) + " " + unit;
}

/// The name of the width or the height of a tooth in a line: the key, or whose it is.
inline std::string toothKey(const BaseDefinition& base, const char* measure)
{
  return base.profile.empty() ? std::string("base.tooth_") + measure
                              : std::string("base.profile's ") + measure;
}

/// From the lowest to the highest point of the teeth [m].
inline double relief(const BaseDefinition& base)
{
  return base.depth() + base.highest();
}

/// Collects the lines.
class SceneWarnings
{
public:
  /// "KEY = VALUE UNIT: REASON; did you mean MEANT UNIT?"
  void add(const std::string& key, double value, const char* unit, const std::string& reason,
           const std::optional<double>& suggested = std::nullopt)
  {
    std::string line = key + " = " + scalarText(value) + " " + unit + ": " + reason;
    if (suggested)
      line += "; did you mean " + quantity(*suggested, unit) + "?";
    lines_.push_back(line);
  }

  void add(const std::string& line) { lines_.push_back(line); }

  std::size_t size() const { return lines_.size(); }

  std::vector<std::string> take() { return std::move(lines_); }

private:
  std::vector<std::string> lines_;
};

/// The value times the factor between two units, if that is plausible.
template <typename Plausible>
std::optional<double> suggestUnit(double value, double factor, Plausible&& plausible)
{
  return plausible(value * factor) ? std::optional(value * factor) : std::nullopt;
}

/// Whether a drive is strong enough to throw disks up, or nearly so.
bool shakes(const DriveBounds& drive, double gravity);

void warnOfDrive(const SceneDefinition& scene, SceneWarnings& warnings);
/// About a drive that is too weak to throw disks up.
void warnOfLift(const SceneDefinition& scene, SceneWarnings& warnings);
void warnOfAngles(const SceneDefinition& scene, SceneWarnings& warnings);
void warnOfGravity(const SceneDefinition& scene, SceneWarnings& warnings);

/// About `accuracy`.
/// @param speed of the fastest disks, after the start [m/s]
void warnOfAccuracy(const SceneDefinition& scene, double speed, SceneWarnings& warnings);

/// The line on a wrong unit in many keys, such as all lengths in mm, if the scene is plausible without this
/// mistake.
std::optional<std::string> unitSlip(const SceneDefinition& scene,
                                    const std::function<bool(const SceneDefinition&)>& plausible);

}  // namespace ratchet_sieve
