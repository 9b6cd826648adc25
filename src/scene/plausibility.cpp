#include "plausibility.h"

#include <cmath>
#include <sstream>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/scene/scalars.h"
#include "ratchet_sieve/scene/shown_text.h"

namespace ratchet_sieve
{

std::string figureText(const Figure& figure)
{
  std::ostringstream out;
  const bool whole = std::abs(figure.value) >= 1e4 && std::abs(figure.value) < 1e9;
  out.precision(whole ? 0 : 4);
  if (whole)
    out << std::fixed;
  out << figure.value;
  if (*figure.unit != '\0')
    out << ' ' << figure.unit;
  return out.str();
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

using Values = std::vector<double*>;

Values lengthsOfBase(SceneDefinition& scene)
{
  BaseDefinition& base = scene.base;
  Values values = {&base.tooth_width, &base.tooth_height, &base.amplitude, &base.horizontal_amplitude,
                   &base.wall_height};
  for (OutlineCorner& corner : base.profile)
    values.insert(values.end(), {&corner.s, &corner.n});
  for (HarmonicDefinition& harmonic : base.harmonics)
    values.insert(values.end(), {&harmonic.amplitude, &harmonic.horizontal_amplitude});
  return values;
}

Values lengthsOfDisks(SceneDefinition& scene)
{
  Values values = {&scene.pour.drop_height, &scene.pour.stretch.from, &scene.pour.stretch.to,
                   &scene.feed.stretch.from, &scene.feed.stretch.to};
  for (SpeciesDefinition& species : scene.species)
  {
    values.push_back(&species.radius);
    for (double& radius : species.size.radii)
      values.push_back(&radius);
  }
  for (InitialDisk& disk : scene.initial)
    values.insert(values.end(), {&disk.x, &disk.y});
  return values;
}

Values masses(SceneDefinition& scene)
{
  Values values;
  for (SpeciesDefinition& species : scene.species)
    values.push_back(&species.mass);
  return values;
}

Values speeds(SceneDefinition& scene)
{
  Values values = {&scene.gravity, &scene.contact.min_rebound_speed, &scene.contact.restitution_speed,
                   &scene.pour.speed, &scene.accuracy.mean_vx};
  for (InitialDisk& disk : scene.initial)
    values.insert(values.end(), {&disk.vx, &disk.vy});
  return values;
}

/// One mistake with units in many keys.
struct UnitSlip
{
  const char* text;
  std::vector<Values (*)(SceneDefinition&)> values;  ///< all a thousand times too large
  bool counts = false;                               ///< as well, which follow from a density
};

const std::vector<UnitSlip>& unitSlips()
{
  static const std::vector<UnitSlip> ALL = {
      {"lengths in mm", {lengthsOfBase, lengthsOfDisks}},
      {"lengths in mm and masses in g", {lengthsOfBase, lengthsOfDisks, masses}},
      {"lengths in mm, speeds in mm/s and gravity in mm/s^2", {lengthsOfBase, lengthsOfDisks, speeds}},
      {"lengths in mm, speeds in mm/s, gravity in mm/s^2 and masses in g",
       {lengthsOfBase, lengthsOfDisks, speeds, masses}},
      {"lengths of the base in mm", {lengthsOfBase}},
      {"lengths of the base in mm", {lengthsOfBase}, true},
  };
  return ALL;
}

SceneDefinition mendedOf(const UnitSlip& slip, const SceneDefinition& scene)
{
  SceneDefinition mended = scene;
  for (const auto values : slip.values)
    for (double* value : values(mended))
      *value *= MILLI;
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
