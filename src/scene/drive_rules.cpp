#include <cmath>

#include "plausibility.h"
#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"

namespace ratchet_sieve
{
namespace
{

constexpr double HARDEST_DRIVE = 150.0;      ///< A omega^2 / g; a feeder's is below 10
constexpr double SOFTEST_DRIVE = 5e-4;       ///< A omega^2 / g
constexpr double WIDEST_STROKE = 5.0;        ///< amplitude / tooth_width
constexpr double STRONGEST_GRAVITY = 500.0;  ///< [m/s^2]

/// Lowest plausible gravity if the drive is too hard only relative to it; the moon's is 1.6 [m/s^2].
constexpr double WEAKEST_GRAVITY = 1.0;
constexpr double EARTH = 9.81;  ///< [m/s^2]

bool isTame(const DriveBounds& drive, double gravity)
{
  return drive.speed <= FASTEST && (gravity == 0.0 || drive.acceleration <= HARDEST_DRIVE * gravity);
}

void judgePhase(const std::string& key, double& phase, Plausibility& is)
{
  const double turns = 0.5 / PI * phase;
  is.rule("turns", Subject(key, phase, "rad"), std::abs(turns), 1.0, "# turns of the drive", {{turns}},
          {PI / 180.0});
}

}  // namespace

void judgeDrive(SceneDefinition& scene, Plausibility& is)
{
  BaseDefinition& base = scene.base;
  const double gravity = scene.gravity;
  const DriveBounds drive = driveBounds(base);
  const bool sideways = std::abs(base.horizontal_amplitude) > base.amplitude;
  double& amplitude = sideways ? base.horizontal_amplitude : base.amplitude;
  const Subject stroke(sideways ? "base.horizontal_amplitude" : "base.amplitude", amplitude, "m");
  const Subject frequency("base.frequency", base.frequency, "Hz");
  const double in_gravity = drive.acceleration > 0.0 ? drive.acceleration / gravity : 0.0;
  const Figure speed{drive.speed, "m/s"}, acceleration{drive.acceleration, "m/s^2"};

  // A drive that is too hard only because gravity is weak is not to blame.
  const bool weightless = gravity < WEAKEST_GRAVITY && !isTame(drive, gravity) && isTame(drive, EARTH);
  const bool wild = !isTame(drive, gravity) && !weightless;
  const double widest = (wild ? 1.0 : WIDEST_STROKE) * base.toothWidth();
  is.rule("wide-stroke", stroke, drive.displacement, widest,
          "# times a tooth's width, and at base.frequency = # the base reaches # and #, # times gravity",
          {{amplitude / base.toothWidth()}, {base.frequency, "Hz"}, speed, acceleration, {in_gravity}},
          {MILLI});
  const bool narrow = drive.displacement <= widest;
  is.rule("hard-drive", frequency, when(narrow && wild), 0.0,
          "with an amplitude of # the base reaches # and #, # times gravity",
          {{amplitude, "m"}, speed, acceleration, {in_gravity}}, {0.5 / PI, 1.0 / 60.0, MILLI});
  const bool soft = drive.acceleration > 0.0 && drive.acceleration < SOFTEST_DRIVE * gravity;
  is.rule("soft-drive", frequency, when(narrow && soft), 0.0,
          "with an amplitude of # the base reaches # and #, # times gravity, too weak to lift a disk",
          {{amplitude, "m"}, speed, acceleration, {in_gravity}}, {1.0 / MILLI});

  is.rule("weak-gravity", Subject("gravity", scene.gravity, "m/s^2"), when(weightless), 0.0,
          "# times that of the earth, and the base reaches #", {{gravity / EARTH}, acceleration},
          {1.0 / MILLI});
  is.rule("strong-gravity", Subject("gravity", scene.gravity, "m/s^2"), gravity, STRONGEST_GRAVITY,
          "# times that of the earth", {{gravity / EARTH}}, {1e-2, MILLI});

  // Without a drive disks are at rest; a weak drive or a strong gravity has a line of its own.
  const bool poured = scene.feed.any() || (scene.initial.empty() && disksAtStart(scene) > 0);
  const double lift = peakLift(base);
  is.rule("no-lift", {},
          when(poured && !soft && drive.acceleration > 0.0 && gravity <= STRONGEST_GRAVITY && lift < gravity),
          0.0,
          "the drive's peak acceleration downwards, #, is # times gravity; below 1 it throws no disk up, and "
          "disks that are poured or fed pile up",
          {{lift, "m/s^2"}, {lift / gravity}});
}

void judgeAngles(SceneDefinition& scene, Plausibility& is)
{
  BaseDefinition& base = scene.base;
  is.rule("steep", Subject("base.inclination", base.inclination, "rad"), std::abs(base.inclination), 0.6,
          "# degrees", {{180.0 / PI * base.inclination}}, {PI / 180.0});
  judgePhase("base.phase", base.phase, is);
  judgePhase("base.horizontal_phase", base.horizontal_phase, is);
  for (std::size_t i = 0; i < base.harmonics.size(); ++i)
  {
    const std::string harmonic = "base.harmonics." + std::to_string(i) + ".";
    judgePhase(harmonic + "phase", base.harmonics[i].phase, is);
    judgePhase(harmonic + "horizontal_phase", base.harmonics[i].horizontal_phase, is);
  }
}

}  // namespace ratchet_sieve
