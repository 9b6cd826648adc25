#include <array>
#include <cmath>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "scene_warnings.h"

namespace ratchet_sieve
{
namespace
{
constexpr double MILLI = 1e-3;

void mendBase(SceneDefinition& scene)
{
  BaseDefinition& base = scene.base;
  for (double* length : {&base.tooth_width, &base.tooth_height, &base.amplitude, &base.horizontal_amplitude,
                         &base.wall_height})
    *length *= MILLI;
  for (OutlineCorner& corner : base.profile)
  {
    corner.s *= MILLI;
    corner.n *= MILLI;
  }
  for (HarmonicDefinition& harmonic : base.harmonics)
  {
    harmonic.amplitude *= MILLI;
    harmonic.horizontal_amplitude *= MILLI;
  }
}

void mendLengths(SceneDefinition& scene)
{
  mendBase(scene);
  for (double* length : {&scene.pour.drop_height, &scene.pour.stretch.from, &scene.pour.stretch.to,
                         &scene.feed.stretch.from, &scene.feed.stretch.to})
    *length *= MILLI;
  for (SpeciesDefinition& species : scene.species)
  {
    species.radius *= MILLI;
    for (double& radius : species.size.radii)
      radius *= MILLI;
  }
  for (InitialDisk& disk : scene.initial)
  {
    disk.x *= MILLI;
    disk.y *= MILLI;
  }
}

void mendMasses(SceneDefinition& scene)
{
  for (SpeciesDefinition& species : scene.species)
    species.mass *= MILLI;
}

/// For counts that follow from a density.
void mendCounts(SceneDefinition& scene)
{
  for (SpeciesDefinition& species : scene.species)
    species.count = static_cast<int>(std::round(species.count * MILLI));
}

void mendSpeeds(SceneDefinition& scene)
{
  for (double* speed : {&scene.gravity, &scene.contact.min_rebound_speed, &scene.contact.restitution_speed,
                        &scene.pour.speed, &scene.accuracy.mean_vx})
    *speed *= MILLI;
  for (InitialDisk& disk : scene.initial)
  {
    disk.vx *= MILLI;
    disk.vy *= MILLI;
  }
}

/// One mistake with units in many keys.
struct UnitSlip
{
  const char* text;
  std::array<void (*)(SceneDefinition&), 3> mends;
};

constexpr void (*NONE)(SceneDefinition&) = nullptr;
constexpr UnitSlip UNIT_SLIPS[] = {
    {"lengths in mm", {mendLengths, NONE, NONE}},
    {"lengths in mm and masses in g", {mendLengths, mendMasses, NONE}},
    {"lengths in mm, speeds in mm/s and gravity in mm/s^2", {mendLengths, mendSpeeds, NONE}},
    {"lengths in mm, speeds in mm/s, gravity in mm/s^2 and masses in g",
     {mendLengths, mendSpeeds, mendMasses}},
    {"lengths of the base in mm", {mendBase, NONE, NONE}},
    {"lengths of the base in mm", {mendBase, mendCounts, NONE}},
};

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
    intended += separator + quantity(shown.value(mended), shown.unit);
  }
  return given + ": the base is " + quantity(scene.base.width(), "m") + " wide and reaches " +
         quantity(driveBounds(scene.base).speed, "m/s") + "; are " + slip.text + "? Did you mean " +
         intended + "?";
}
}  // namespace

std::optional<std::string> unitSlip(const SceneDefinition& scene,
                                    const std::function<bool(const SceneDefinition&)>& plausible)
{
  for (const UnitSlip& slip : UNIT_SLIPS)
  {
    SceneDefinition mended = scene;
    for (const auto mend : slip.mends)
      if (mend != NONE)
        mend(mended);
    if (plausible(mended))
      return slipLine(slip, scene, mended);
  }
  return std::nullopt;
}

}  // namespace ratchet_sieve
