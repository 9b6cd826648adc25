#include "ratchet_sieve/scene/implausibilities.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "doubts.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/resolution.h"

namespace ratchet_sieve
{
namespace
{
constexpr double PI = 3.14159265358979323846;

// Beyond these a scene can be run but hardly meant. Where a length of the scene serves as the measure, any
// size of machine is plausible; metres and m/s stand only where people think of a bench-top machine.
constexpr double TALLEST_TOOTH = 10.0;       ///< tooth_height / tooth_width
constexpr double FINEST_DISK = 1.0 / 500;    ///< largest diameter / tooth_width
constexpr double WIDEST_STROKE = 5.0;        ///< amplitude / tooth_width
constexpr double HARDEST_DRIVE = 150.0;      ///< A omega^2 / g; a feeder's is below 10
constexpr double SOFTEST_DRIVE = 5e-4;       ///< A omega^2 / g
constexpr double FASTEST = 150.0;            ///< [m/s], of the drive, of disks and of their rims
constexpr double STEEPEST = 0.6;             ///< [rad]
constexpr double MOST_TURNS = 1.0;           ///< of the drive, in its phase
constexpr double STRONGEST_GRAVITY = 500.0;  ///< [m/s^2]
constexpr double DENSEST_DISK =
    1e8;                            ///< [kg/m^3], as a sphere; osmium's is 2.3e4, that of the paper's A 2.4e6
constexpr double TALL_LAYER = 1.0;  ///< [m], where it is
constexpr double DISKS_IN_LAYER = 100.0;  ///< so many of the largest diameters, too
constexpr double LAYER_TO_WIDTH = 2.0;    ///< layer / base's width
constexpr double HIGH_DROP = 1.0;         ///< [m], where it is
constexpr double TEETH_IN_DROP = 20.0;    ///< so many tooth widths, too
constexpr double LONGEST_RUN = 1e6;       ///< in drive periods

double largestDiameter(const SceneDefinition& scene)
{
  double largest = 0.0;
  for (const SpeciesDefinition& species : scene.species)
    largest = std::max(largest, 2.0 * species.radius);
  return largest;
}

std::string speciesKey(std::size_t index, const char* key)
{
  return "species." + std::to_string(index) + "." + key;
}

void doubtNumbers(const SceneDefinition& scene, Doubts& doubts)
{
  if (disksAtStart(scene) == 0 && scene.feed.rate <= 0.0)
    doubts.add(
        "no disk at all: every species.N.count is 0, initial is empty and feed.rate is 0; a density gives a "
        "disk where it times the base's width, " +
        quantity(scene.base.width(), "m") + ", comes to the disks' diameters, the largest " +
        quantity(largestDiameter(scene), "m"));
}

void doubtRadii(const SceneDefinition& scene, Doubts& doubts)
{
  const BaseDefinition& base = scene.base;
  const double room = base.tooth_height > 0.0 ? base.tooth_width : base.width();
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    const double radius = scene.species[i].radius;
    if (2.0 * radius <= room)
      continue;
    const std::string figure =
        "a disk's diameter, " + quantity(2.0 * radius, "m") +
        (2.0 * radius > base.width()
             ? ", is larger than the base's width, " + quantity(base.width(), "m")
             : ", is larger than a tooth's valley, base.tooth_width = " + quantity(base.tooth_width, "m"));
    doubts.add(
        speciesKey(i, "radius"), radius, "m", figure,
        meant(radius, 1e-3, [&](double r) { return 2.0 * r <= room && 200.0 * r >= base.tooth_width; }));
  }
}

void doubtMasses(const SceneDefinition& scene, Doubts& doubts)
{
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    const SpeciesDefinition& species = scene.species[i];
    const double volume = 4.0 / 3.0 * PI * std::pow(species.radius, 3);
    if (species.mass > DENSEST_DISK * volume)
      doubts.add(speciesKey(i, "mass"), species.mass, "kg",
                 "with " + speciesKey(i, "radius") + " = " + quantity(species.radius, "m") + " a sphere of " +
                     quantity(species.mass / volume, "kg/m^3") + ", where osmium has 22590",
                 meant(species.mass, 1e-3, [&](double mass) { return mass <= DENSEST_DISK * volume; }));
  }
}

void doubtTeeth(const SceneDefinition& scene, Doubts& doubts)
{
  const BaseDefinition& base = scene.base;
  const double diameter = largestDiameter(scene);
  const auto wide = [&](double width) { return diameter < FINEST_DISK * width; };
  const auto tall = [&](double height) { return height > TALLEST_TOOTH * base.tooth_width; };
  if (wide(base.tooth_width))
    doubts.add(
        "base.tooth_width", base.tooth_width, "m",
        number(base.tooth_width / diameter) + " times the diameter of the largest disks, " +
            quantity(diameter, "m"),
        meant(base.tooth_width, 1e-3, [&](double width) { return !wide(width) && diameter <= width; }));
  if (tall(base.tooth_height))
    doubts.add("base.tooth_height", base.tooth_height, "m",
               "needles, " + number(base.tooth_height / base.tooth_width) +
                   " times as high as base.tooth_width = " + quantity(base.tooth_width, "m"),
               meant(base.tooth_height, 1e-3, [&](double height) { return !tall(height); }));
}

DriveBounds drivenAt(BaseDefinition base, double frequency)
{
  base.frequency = frequency;
  return driveBounds(base);
}

bool isTame(const DriveBounds& drive, double gravity)
{
  return drive.speed <= FASTEST && (gravity == 0.0 || drive.acceleration <= HARDEST_DRIVE * gravity);
}

/// One whose frequency is in turns a minute or in rad/s.
std::optional<double> meantFrequency(const SceneDefinition& scene)
{
  const auto tame = [&](double frequency) { return isTame(drivenAt(scene.base, frequency), scene.gravity); };
  const auto from_radians = meant(scene.base.frequency, 0.5 / PI, tame);
  return from_radians ? from_radians : meant(scene.base.frequency, 1.0 / 60.0, tame);
}

/// The amplitude that a doubt of the drive names: A, unless the base goes farther sideways.
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

void doubtDrive(const SceneDefinition& scene, Doubts& doubts)
{
  const BaseDefinition& base = scene.base;
  const DriveBounds now = driveBounds(base);
  std::string figure =
      "the base moves at up to " + quantity(now.speed, "m/s") + " and " + quantity(now.acceleration, "m/s^2");
  if (scene.gravity > 0.0)
    figure += ", " + number(now.acceleration / scene.gravity) + " times gravity";

  const NamedAmplitude named = namedAmplitude(base);
  const double amplitude = base.*named.value;
  const std::string with = std::string("with ") + named.key + " = " + quantity(amplitude, "m") + " ";
  const bool far = now.displacement > WIDEST_STROKE * base.tooth_width;
  const bool tame = isTame(now, scene.gravity);
  const auto frequency = far ? std::nullopt : meantFrequency(scene);
  if (far || (!tame && !frequency))
    doubts.add(named.key, amplitude, "m",
               number(amplitude / base.tooth_width) + " times base.tooth_width, and at base.frequency = " +
                   quantity(base.frequency, "Hz") + " " + figure,
               meant(amplitude, 1e-3,
                     [&](double a)
                     {
                       BaseDefinition smaller = base;
                       smaller.*named.value = a;
                       const DriveBounds then = driveBounds(smaller);
                       return then.displacement <= base.tooth_width && isTame(then, scene.gravity) &&
                              then.acceleration >= 0.5 * scene.gravity;
                     }));
  else if (!tame)
    doubts.add("base.frequency", base.frequency, "Hz", with + figure, frequency);
  else if (now.acceleration > 0.0 && now.acceleration < SOFTEST_DRIVE * scene.gravity)
    doubts.add(
        "base.frequency", base.frequency, "Hz", with + figure + ", and no disk leaves it",
        meant(base.frequency, 1e3, [&](double f) { return isTame(drivenAt(base, f), scene.gravity); }));
}

void doubtAngles(const SceneDefinition& scene, Doubts& doubts)
{
  const double inclination = scene.base.inclination;
  if (std::abs(inclination) > STEEPEST)
    doubts.add("base.inclination", inclination, "rad", number(180.0 / PI * inclination) + " degrees",
               inclination * PI / 180.0);
  const auto doubt_phase = [&](const std::string& key, double phase)
  {
    if (std::abs(phase) > MOST_TURNS * 2.0 * PI)
      doubts.add(key, phase, "rad", number(0.5 / PI * phase) + " turns of the drive", phase * PI / 180.0);
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

void doubtGravity(const SceneDefinition& scene, Doubts& doubts)
{
  if (scene.gravity <= STRONGEST_GRAVITY)
    return;
  const auto earthly = [](double gravity) { return gravity > 1.0 && gravity < 20.0; };
  const auto from_centimetres = meant(scene.gravity, 1e-2, earthly);
  doubts.add("gravity", scene.gravity, "m/s^2", number(scene.gravity / 9.81) + " times that of the earth",
             from_centimetres ? from_centimetres : meant(scene.gravity, 1e-3, earthly));
}

void doubtLayer(const SceneDefinition& scene, Doubts& doubts)
{
  const double width = scene.base.width();
  const double diameter = largestDiameter(scene);
  const std::size_t disks = disksAtStart(scene);
  const double layer = settledLayer(scene);
  const bool tall = layer > TALL_LAYER && layer > DISKS_IN_LAYER * diameter;
  // A single disk in a narrow machine is no layer.
  if (tall || (layer > LAYER_TO_WIDTH * width && layer > diameter && disks > 1))
    doubts.add("the counts of all species come to " + std::to_string(disks) + " disks: at rest a layer of " +
               quantity(layer, "m") + ", " + number(layer / diameter) +
               " of the largest diameters thick, on a base " + quantity(width, "m") +
               " wide; a smaller density, smaller counts or larger radii meant?");
  const double growth = feedGrowth(scene) * timeScale(scene);
  if (growth > diameter)
    doubts.add("feed.rate", scene.feed.rate, "1/s",
               "raises the layer by " + quantity(feedGrowth(scene), "m/s") + ", " +
                   number(growth / diameter) + " disks within the machine's time scale of " +
                   quantity(timeScale(scene), "s"),
               meant(scene.feed.rate, 1e-3,
                     [&](double rate) { return growth * rate / scene.feed.rate <= diameter; }));
}

bool isHigh(const SceneDefinition& scene, double height)
{
  return height > HIGH_DROP && height > TEETH_IN_DROP * scene.base.tooth_width;
}

/// After a fall without a start [m/s].
double fallSpeed(const SceneDefinition& scene, double height)
{
  return std::sqrt(2.0 * scene.gravity * height);
}

void doubtPour(const SceneDefinition& scene, Doubts& doubts)
{
  if (!scene.initial.empty() && scene.feed.rate <= 0.0)
    return;
  const double height = scene.pour.drop_height;
  if (isHigh(scene, height))
    doubts.add("pour.drop_height", height, "m",
               number(height / scene.base.tooth_width) + " times base.tooth_width; disks come down at " +
                   quantity(fallSpeed(scene, height), "m/s"),
               meant(height, 1e-3, [&](double h) { return !isHigh(scene, h); }));
  if (scene.pour.speed > FASTEST)
    doubts.add(
        "pour.speed", scene.pour.speed, "m/s",
        number(1e-3 * scene.pour.speed / scene.base.tooth_width) + " times base.tooth_width in a millisecond",
        meant(scene.pour.speed, 1e-3, [](double speed) { return speed <= FASTEST; }));
}

double speedOf(const InitialDisk& disk)
{
  return std::hypot(disk.vx, disk.vy);
}

/// The first of the disks placed by hand that is too high, too fast or spins too fast.
void doubtInitial(const SceneDefinition& scene, Doubts& doubts)
{
  const double slope = std::tan(scene.base.inclination);
  for (std::size_t i = 0; i < scene.initial.size(); ++i)
  {
    const InitialDisk& disk = scene.initial[i];
    const std::string key = "initial." + std::to_string(i);
    const double height = disk.y - slope * disk.x;
    const double rim = std::abs(disk.spin) * scene.species[disk.species].radius;
    const std::size_t before = doubts.size();
    if (isHigh(scene, height))
      doubts.add(key + ".y", disk.y, "m",
                 quantity(height, "m") + " above the base, " + number(height / scene.base.tooth_width) +
                     " times base.tooth_width",
                 meant(disk.y, 1e-3, [&](double y) { return y > slope * disk.x; }));
    if (speedOf(disk) > FASTEST)
      doubts.add(key + ": a speed of " + quantity(speedOf(disk), "m/s") + " (vx, vy): given in mm/s?");
    if (rim > FASTEST)
      doubts.add(key + ".spin", disk.spin, "rad/s", "the disk's rim goes at " + quantity(rim, "m/s"));
    if (doubts.size() > before)
      return;
  }
}

/// The fastest that disks get by falling, being thrown or being started, without a collision [m/s].
double ordinarySpeed(const SceneDefinition& scene)
{
  double start = scene.initial.empty() || scene.feed.rate > 0.0
                     ? scene.pour.speed + fallSpeed(scene, scene.pour.drop_height)
                     : 0.0;
  for (const InitialDisk& disk : scene.initial)
    start = std::max(start, speedOf(disk) + fallSpeed(scene, std::abs(disk.y)));
  return start + fallSpeed(scene, scene.base.tooth_height) + driveBounds(scene.base).speed;
}

void doubtContact(const SceneDefinition& scene, Doubts& doubts)
{
  const double speed = ordinarySpeed(scene);
  const double floor = scene.contact.min_rebound_speed;
  if (speed > 0.0 && floor > speed)
    doubts.add("contact.min_rebound_speed", floor, "m/s",
               "faster than fall, pour and drive together make a disk, " + quantity(speed, "m/s") +
                   ": every contact throws disks apart",
               meant(floor, 1e-3, [&](double v) { return v <= speed; }));
  const double scale = timeScale(scene);
  const double duration = scene.contact.contact_duration;
  if (duration > scale)
    doubts.add(
        "contact.contact_duration", duration, "s",
        "longer than the machine's time scale, " + quantity(scale, "s") + ": hardly any contact loses energy",
        meant(duration, 1e-3, [&](double t) { return t <= scale; }));
}

/// By drive periods or, without a drive, by falls over a tooth.
void doubtDuration(const SceneDefinition& scene, Doubts& doubts)
{
  const bool driven = scene.base.frequency > 0.0;
  const double period =
      driven ? 1.0 / scene.base.frequency : std::sqrt(scene.base.tooth_width / scene.gravity);
  if (scene.duration > LONGEST_RUN * period)
    doubts.add("duration", scene.duration, "s",
               number(scene.duration / 3600.0) + " hours, " + number(scene.duration / period) +
                   (driven ? " drive periods" : " times as long as a fall over a tooth"),
               1e-3 * scene.duration);
}
}  // namespace

std::vector<std::string> implausibilities(const SceneDefinition& scene)
{
  Doubts doubts;
  for (const auto doubt : {doubtNumbers, doubtRadii, doubtMasses, doubtTeeth, doubtDrive, doubtAngles,
                           doubtGravity, doubtLayer, doubtPour, doubtInitial, doubtContact, doubtDuration})
    doubt(scene, doubts);
  doubtSteps(scene, ordinarySpeed(scene), doubts);
  return doubts.take();
}

}  // namespace ratchet_sieve
