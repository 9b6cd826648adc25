#include <cmath>
#include <optional>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/layer.h"
#include "scene_warnings.h"

namespace ratchet_sieve
{
namespace
{
constexpr double WIDEST_STROKE = 5.0;        ///< amplitude / tooth_width
constexpr double HARDEST_DRIVE = 150.0;      ///< A omega^2 / g; a feeder's is below 10
constexpr double SOFTEST_DRIVE = 5e-4;       ///< A omega^2 / g
constexpr double STEEPEST = 0.6;             ///< [rad]
constexpr double MOST_TURNS = 1.0;           ///< of the drive, in its phase
constexpr double STRONGEST_GRAVITY = 500.0;  ///< [m/s^2]

/// Lowest plausible gravity if the drive is too hard only relative to it; the moon's is 1.6 [m/s^2].
constexpr double WEAKEST_GRAVITY = 1.0;

constexpr double EARTH = 9.81;  ///< [m/s^2]

DriveBounds drivenAt(BaseDefinition base, double frequency)
{
  base.frequency = frequency;
  return driveBounds(base);
}

bool isTame(const DriveBounds& drive, double gravity)
{
  return drive.speed <= FASTEST && (gravity == 0.0 || drive.acceleration <= HARDEST_DRIVE * gravity);
}

/// A plausible frequency, if the given one is in rad/s, revolutions per minute or mHz.
std::optional<double> suggestedFrequency(const SceneDefinition& scene)
{
  for (const double factor : {0.5 / PI, 1.0 / 60.0, 1e-3})
    if (isTame(drivenAt(scene.base, factor * scene.base.frequency), scene.gravity))
      return factor * scene.base.frequency;
  return std::nullopt;
}

/// The amplitude that a doubt about the drive names: A, unless the horizontal one is larger.
struct NamedAmplitude
{
  const char* key;
  double BaseDefinition::*value;
};

NamedAmplitude namedAmplitude(const BaseDefinition& base)
{
  if (std::abs(base.horizontal_amplitude) > base.amplitude)
    return {"base.horizontal_amplitude", &BaseDefinition::horizontal_amplitude};
  return {"base.amplitude", &BaseDefinition::amplitude};
}

std::optional<double> meantAmplitude(const SceneDefinition& scene, const NamedAmplitude& named)
{
  BaseDefinition smaller = scene.base;
  smaller.*named.value *= 1e-3;
  const DriveBounds drive = driveBounds(smaller);
  const bool plausible = drive.displacement <= smaller.toothWidth() && isTame(drive, scene.gravity) &&
                         shakes(drive, scene.gravity);
  return plausible ? std::optional(smaller.*named.value) : std::nullopt;
}

/// Whether the drive is too hard only because gravity is weak.
bool isWeightless(const SceneDefinition& scene)
{
  const DriveBounds drive = driveBounds(scene.base);
  return scene.gravity < WEAKEST_GRAVITY && !isTame(drive, scene.gravity) && isTame(drive, EARTH);
}

}  // namespace

bool shakes(const DriveBounds& drive, double gravity)
{
  return drive.acceleration >= 0.5 * gravity;
}

void warnOfDrive(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const BaseDefinition& base = scene.base;
  const DriveBounds now = driveBounds(base);
  std::string figure =
      "the base reaches " + quantity(now.speed, "m/s") + " and " + quantity(now.acceleration, "m/s^2");
  if (scene.gravity > 0.0)
    figure += ", " + number(now.acceleration / scene.gravity) + " times gravity";

  const NamedAmplitude named = namedAmplitude(base);
  const double amplitude = base.*named.value;
  const std::string with = std::string("with ") + named.key + " = " + quantity(amplitude, "m") + " ";
  const bool wild = !isTame(now, scene.gravity) && !isWeightless(scene);
  if (now.displacement > (wild ? 1.0 : WIDEST_STROKE) * base.toothWidth())
    warnings.add(named.key, amplitude, "m",
                 number(amplitude / base.toothWidth()) + " times " + toothKey(base, "width") +
                     ", and at base.frequency = " + quantity(base.frequency, "Hz") + " " + figure,
                 meantAmplitude(scene, named));
  else if (wild)
    warnings.add("base.frequency", base.frequency, "Hz", with + figure, suggestedFrequency(scene));
  else if (now.acceleration > 0.0 && now.acceleration < SOFTEST_DRIVE * scene.gravity)
    warnings.add(
        "base.frequency", base.frequency, "Hz", with + figure + ", too weak to lift a disk",
        suggestUnit(base.frequency, 1e3, [&](double f) { return isTame(drivenAt(base, f), scene.gravity); }));
}

void warnOfLift(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const bool poured = scene.feed.rate > 0.0 || (scene.initial.empty() && disksAtStart(scene) > 0);
  const DriveBounds now = driveBounds(scene.base);
  // Without a drive disks are at rest; a much weaker drive or an implausible gravity has a line of its own.
  if (!poured || now.acceleration == 0.0 || now.acceleration < SOFTEST_DRIVE * scene.gravity ||
      scene.gravity > STRONGEST_GRAVITY)
    return;
  const double lift = peakLift(scene.base);
  if (lift < scene.gravity)
    warnings.add("the drive's peak acceleration downwards, " + quantity(lift, "m/s^2") + ", is " +
                 number(lift / scene.gravity) +
                 " times gravity; below 1 it throws no disk up, and disks that are poured or fed pile up");
}

void warnOfAngles(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const double inclination = scene.base.inclination;
  if (std::abs(inclination) > STEEPEST)
    warnings.add("base.inclination", inclination, "rad", number(180.0 / PI * inclination) + " degrees",
                 inclination * PI / 180.0);
  const auto doubt_phase = [&](const std::string& key, double phase)
  {
    if (std::abs(phase) > MOST_TURNS * 2.0 * PI)
      warnings.add(key, phase, "rad", number(0.5 / PI * phase) + " turns of the drive", phase * PI / 180.0);
  };
  doubt_phase("base.phase", scene.base.phase);
  doubt_phase("base.horizontal_phase", scene.base.horizontal_phase);
  for (std::size_t i = 0; i < scene.base.harmonics.size(); ++i)
  {
    const std::string harmonic = "base.harmonics." + std::to_string(i) + ".";
    doubt_phase(harmonic + "phase", scene.base.harmonics[i].phase);
    doubt_phase(harmonic + "horizontal_phase", scene.base.harmonics[i].horizontal_phase);
  }
}

void warnOfGravity(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const bool weightless = isWeightless(scene);
  if (scene.gravity <= STRONGEST_GRAVITY && !weightless)
    return;
  std::string figure = number(scene.gravity / EARTH) + " times that of the earth";
  if (weightless)
    figure += ", and the base reaches " + quantity(driveBounds(scene.base).acceleration, "m/s^2");
  std::optional<double> intended;
  for (const double factor : {1e-3, 1e-2, 1e3})
    if (factor * scene.gravity > 1.0 && factor * scene.gravity < 20.0)
      intended = factor * scene.gravity;
  warnings.add("gravity", scene.gravity, "m/s^2", figure, intended);
}

}  // namespace ratchet_sieve
