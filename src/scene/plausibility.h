#pragma once

#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/definition.h"

/// What the rules on implausible scenes are made of: see implausibilities().
namespace ratchet_sieve
{

constexpr double PI = 3.14159265358979323846;
constexpr double MILLI = 1e-3;

/// Highest plausible speed of the drive, of disks and of their rims [m/s].
constexpr double FASTEST = 150.0;

/// A value that a text names.
struct Figure
{
  double value;
  const char* unit = "";
};

/// With four significant digits; a number above 9999 is rounded to an integer.
std::string figureText(const Figure& figure);

/// The subject of a rule: a key of the scene, or no single one.
struct Subject
{
  Subject() = default;
  explicit Subject(std::string name) : key(std::move(name)) {}
  Subject(std::string name, double& scalar, const char* its_unit)
      : key(std::move(name)), value(scalar), unit(its_unit), parts{&scalar}
  {
  }
  Subject(std::string name, double size, const char* its_unit, std::vector<double*> all)
      : key(std::move(name)), value(size), unit(its_unit), parts(std::move(all))
  {
  }

  std::string key;
  std::optional<double> value;
  const char* unit = "";
  std::vector<double*> parts;  ///< of the scene, all of which change with the value
};

/// Judges a scene by rules and collects their lines.
class Plausibility
{
public:
  /// The number of implausible values of the scene as it is now.
  using Count = std::function<std::size_t()>;

  /// @param count for suggestions; without it none are made
  explicit Plausibility(Count count) : count_(std::move(count)) {}

  /// Adds "KEY = VALUE UNIT: TEXT; did you mean MEANT UNIT? [ID]" if the ratio is above the bound. MEANT is
  /// the value times the first of the factors with which less of the scene is implausible.
  /// @param text with # for each of the figures
  void rule(const char* id, const Subject& subject, double ratio, double bound, const char* text,
            std::initializer_list<Figure> figures = {}, std::initializer_list<double> factors = {});

  std::vector<std::string>& lines() { return lines_; }

private:
  std::string suggestion(const Subject& subject, std::initializer_list<double> factors) const;

  Count count_;
  std::vector<std::string> lines_;
};

/// A ratio for a rule on a condition, whose bound is 0.
inline double when(bool holds)
{
  return holds ? 1.0 : 0.0;
}

void judgeDrive(SceneDefinition& scene, Plausibility& is);
void judgeAngles(SceneDefinition& scene, Plausibility& is);

/// The line on a wrong unit in many keys, such as all lengths in mm, if the scene is plausible without this
/// mistake.
std::optional<std::string> unitSlip(const SceneDefinition& scene,
                                    const std::function<bool(const SceneDefinition&)>& plausible);

}  // namespace ratchet_sieve
