#include "plausibility.h"

#include <cmath>

#include <fmt/format.h>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/scene/scalars.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "schema.h"

namespace ratchet_sieve
{

std::string figureText(const Figure& figure)
{
  const bool whole = std::abs(figure.value) >= 1e4 && std::abs(figure.value) < 1e9;
  const std::string number = fmt::format(whole ? "{:.0f}" : "{:.4g}", figure.value);
  return *figure.unit == '\0' ? number : number + ' ' + figure.unit;
}

std::string Plausibility::suggestion(const Subject& subject, std::initializer_list<double> factors) const
{
  if (!count_)
    return "";
  const std::size_t now = count_();
  for (const double factor : factors)
  {
    std::vector<double> given;
    for (double* part : subject.parts)
    {
      given.push_back(*part);
      *part *= factor;
    }
    const std::size_t then = count_();
    for (std::size_t k = 0; k < given.size(); ++k)
      *subject.parts[k] = given[k];
    if (then < now)
      return "; did you mean " + figureText({factor * *subject.value, subject.unit}) + "?";
  }
  return "";
}

void Plausibility::rule(const char* id, const Subject& subject, double ratio, double bound, const char* text,
                        std::initializer_list<Figure> figures, std::initializer_list<double> factors)
{
  if (!(ratio > bound))
    return;
  std::string line = subject.key;
  if (subject.value)
    line += " = " + scalarText(*subject.value) + (*subject.unit == '\0' ? "" : " ") + subject.unit;
  if (!line.empty())
    line += ": ";
  const Figure* next = figures.begin();
  for (const char* c = text; *c != '\0'; ++c)
    if (*c == '#')
      line += figureText(*next++);
    else
      line += *c;
  lines_.push_back(withId(line + suggestion(subject, factors), id));
}

// Of mistakes with units that go through many keys.
namespace
{

/// One mistake with units in many keys.
struct UnitSlip
{
  const char* text;
  std::set<std::string> units;  ///< of the keys whose numbers are a thousand times too large
  bool of_base = false;         ///< in the base's keys alone
  bool counts = false;          ///< as well, which follow from a density
};

const std::vector<UnitSlip>& unitSlips()
{
  static const std::vector<UnitSlip> ALL = {
      {"lengths in mm", {"m"}},
      {"lengths in mm and masses in g", {"m", "kg"}},
      {"lengths in mm, speeds in mm/s and gravity in mm/s^2", {"m", "m/s", "m/s^2"}},
      {"lengths in mm, speeds in mm/s, gravity in mm/s^2 and masses in g", {"m", "m/s", "m/s^2", "kg"}},
      {"lengths of the base in mm", {"m"}, true},
      {"lengths of the base in mm", {"m"}, true, true},
  };
  return ALL;
}

SceneDefinition mendedOf(const UnitSlip& slip, const SceneDefinition& scene)
{
  SceneDefinition mended = scene;
  forEachNumber(mended,
                [&slip](const std::string& part, const char* unit, double& number)
                {
                  if (slip.units.count(unit) > 0 && (part == "base" || !slip.of_base))
                    number *= MILLI;
                });
  if (slip.counts)
    for (SpeciesDefinition& species : mended.species)
      species.count = static_cast<int>(std::round(species.count * MILLI));
  return mended;
}

/// A key that the line on a slip shows.
struct ShownKey
{
  const char* key;
  const char* unit;
  double (*value)(const SceneDefinition& scene);
};

constexpr ShownKey SHOWN_KEYS[] = {
    {"base.tooth_width", "m",
     [](const SceneDefinition& scene) { return scene.base.profile.empty() ? scene.base.toothWidth() : 0.0; }},
    {"base.profile's width", "m",
     [](const SceneDefinition& scene) { return scene.base.profile.empty() ? 0.0 : scene.base.toothWidth(); }},
    {"base.amplitude", "m", [](const SceneDefinition& scene) { return scene.base.amplitude; }},
    {"species.0.radius", "m", [](const SceneDefinition& scene) { return scene.species.front().radius; }},
    {"species.0.mass", "kg", [](const SceneDefinition& scene) { return scene.species.front().mass; }},
    {"gravity", "m/s^2", [](const SceneDefinition& scene) { return scene.gravity; }},
};

std::string slipLine(const UnitSlip& slip, const SceneDefinition& scene, const SceneDefinition& mended)
{
  std::string given, intended;
  for (const ShownKey& shown : SHOWN_KEYS)
  {
    if (shown.value(scene) == shown.value(mended))
      continue;
    const std::string separator = given.empty() ? "" : ", ";
    given += separator + shown.key + " = " + scalarText(shown.value(scene)) + " " + shown.unit;
    intended += separator + figureText({shown.value(mended), shown.unit});
  }
  return given + ": the base is " + figureText({scene.base.width(), "m"}) + " wide and reaches " +
         figureText({driveBounds(scene.base).speed, "m/s"}) + "; are " + slip.text + "? Did you mean " +
         intended + "?";
}
}  // namespace

std::optional<std::string> unitSlip(const SceneDefinition& scene,
                                    const std::function<bool(const SceneDefinition&)>& plausible)
{
  for (const UnitSlip& slip : unitSlips())
  {
    const SceneDefinition mended = mendedOf(slip, scene);
    if (plausible(mended))
      return slipLine(slip, scene, mended);
  }
  return std::nullopt;
}

}  // namespace ratchet_sieve
