#include "ratchet_sieve/scene/implausibilities.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/sizes.h"
#include "scene_warnings.h"

namespace ratchet_sieve
{
namespace
{

// Beyond these limits a scene is valid but implausible. Most are ratios, and hold for machines of any size.
// Limits in m and m/s apply together with a ratio, or are of a machine on a bench.
constexpr double TALLEST_TOOTH = 10.0;     ///< tooth_height / tooth_width
constexpr double FINEST_DISK = 1.0 / 500;  ///< largest diameter / tooth_width
constexpr double DENSEST_DISK =
    1e7;  ///< of a sphere of its radius; osmium: 2.3e4, the paper's A: 2.4e6 [kg/m^3]
constexpr double TALL_LAYER = 1.0;        ///< [m]
constexpr double DISKS_IN_LAYER = 100.0;  ///< layer / largest diameter, of a tall layer
constexpr double LAYER_TO_WIDTH = 2.0;    ///< layer / base's width
constexpr double HIGH_DROP = 1.0;         ///< [m]
constexpr double TEETH_IN_DROP = 20.0;    ///< drop / tooth_width, of a high drop
constexpr double LONGEST_RUN = 1e6;       ///< in drive periods

std::string speciesKey(std::size_t index, const char* key)
{
  return "species." + std::to_string(index) + "." + key;
}

void warnOfNumbers(const SceneDefinition& scene, SceneWarnings& warnings)
{
  if (disksAtStart(scene) == 0 && scene.feed.rate <= 0.0)
    warnings.add(
        "no disks: every species.N.count is 0, initial is empty and feed.rate is 0; a density, if given, is "
        "too "
        "small: the base is " +
        quantity(scene.base.width(), "m") + " wide and the largest diameter is " +
        quantity(largestDiameter(scene), "m"));
}

/// The width available to a disk, between two teeth or on a flat base [m].
double valley(const BaseDefinition& base)
{
  return relief(base) > 0.0 ? base.toothWidth() : base.width();
}

void warnOfRadii(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const BaseDefinition& base = scene.base;
  const double room = valley(base);
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    const double radius = Sizes(scene.species[i]).largest();
    if (2.0 * radius <= room)
      continue;
    const std::string figure =
        "a disk's diameter, " + quantity(2.0 * radius, "m") +
        (2.0 * radius > base.width() ? ", is larger than the base's width, " + quantity(base.width(), "m")
                                     : ", is larger than a tooth, " + toothKey(base, "width") + " = " +
                                           quantity(base.toothWidth(), "m"));
    warnings.add(speciesKey(i, "radius"), radius, "m", figure,
                 suggestUnit(radius, 1e-3,
                             [&](double r) { return 2.0 * r <= room && 200.0 * r >= base.toothWidth(); }));
  }
}

double sphere(double radius)
{
  return 4.0 / 3.0 * PI * std::pow(radius, 3);
}

void warnOfMass(const SceneDefinition& scene, std::size_t index, SceneWarnings& warnings)
{
  const double mass = scene.species[index].mass;
  const double radius = scene.species[index].radius;
  const auto dense = [](double m, double r) { return m > DENSEST_DISK * sphere(r); };
  if (!dense(mass, radius))
    return;
  const std::string mass_key = speciesKey(index, "mass");
  const std::string radius_key = speciesKey(index, "radius");
  const std::string figure = " the density of a sphere would be " +
                             quantity(mass / sphere(radius), "kg/m^3") + "; osmium has 22590 kg/m^3";
  const auto lighter = suggestUnit(mass, 1e-3, [&](double m) { return !dense(m, radius); });
  const auto larger =
      suggestUnit(radius, 1e3, [&](double r) { return !dense(mass, r) && 2.0 * r <= valley(scene.base); });
  if (larger && !lighter)
    warnings.add(radius_key, radius, "m", "with " + mass_key + " = " + quantity(mass, "kg") + figure, larger);
  else
    warnings.add(mass_key, mass, "kg", "with " + radius_key + " = " + quantity(radius, "m") + figure,
                 lighter);
}

void warnOfMasses(const SceneDefinition& scene, SceneWarnings& warnings)
{
  for (std::size_t i = 0; i < scene.species.size(); ++i)
    warnOfMass(scene, i, warnings);
}

void warnOfTeeth(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const BaseDefinition& base = scene.base;
  const double diameter = largestDiameter(scene);
  const auto wide = [&](double width) { return diameter < FINEST_DISK * width; };
  const double width = base.toothWidth();
  const double height = relief(base);
  const auto tall = [&](double h) { return h > TALLEST_TOOTH * width; };
  if (wide(width))
    warnings.add(
        toothKey(base, "width"), width, "m",
        number(width / diameter) + " times the diameter of the largest disks, " + quantity(diameter, "m"),
        suggestUnit(width, 1e-3, [&](double w) { return !wide(w) && diameter <= w; }));
  if (tall(height))
    warnings.add(toothKey(base, "height"), height, "m",
                 number(height / width) + " times " + toothKey(base, "width") + " = " + quantity(width, "m"),
                 suggestUnit(height, 1e-3, [&](double h) { return !tall(h); }));
}

void warnOfLayer(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const double width = scene.base.width();
  const double diameter = largestDiameter(scene);
  const std::size_t disks = disksAtStart(scene);
  const double layer = settledLayer(scene);
  const bool tall = layer > TALL_LAYER && layer > DISKS_IN_LAYER * diameter;
  // A single disk in a narrow machine is not a layer.
  if (tall || (layer > LAYER_TO_WIDTH * width && layer > diameter && disks > 1))
    warnings.add("the counts of all species sum to " + std::to_string(disks) + " disks: at rest a layer " +
                 quantity(layer, "m") + " thick, " + number(layer / diameter) +
                 " of the largest diameters, on a base " + quantity(width, "m") +
                 " wide; did you mean a smaller density, smaller counts or larger radii?");
  const double growth = feedGrowth(scene) * timeScale(scene);
  if (growth > diameter)
    warnings.add(
        "feed.rate", scene.feed.rate, "1/s",
        "raises the layer by " + quantity(feedGrowth(scene), "m/s") + ", " + number(growth / diameter) +
            " of the largest diameters within the machine's time scale, " + quantity(timeScale(scene), "s"),
        suggestUnit(scene.feed.rate, 1e-3,
                    [&](double rate) { return growth * rate / scene.feed.rate <= diameter; }));
}

bool isHigh(const SceneDefinition& scene, double height)
{
  return height > HIGH_DROP && height > TEETH_IN_DROP * scene.base.toothWidth();
}

/// After a fall from rest [m/s].
double fallSpeed(const SceneDefinition& scene, double height)
{
  return std::sqrt(2.0 * scene.gravity * height);
}

void warnOfPour(const SceneDefinition& scene, SceneWarnings& warnings)
{
  if (!scene.initial.empty() && scene.feed.rate <= 0.0)
    return;
  const double height = scene.pour.drop_height;
  if (isHigh(scene, height))
    warnings.add("pour.drop_height", height, "m",
                 number(height / scene.base.toothWidth()) + " times " + toothKey(scene.base, "width") +
                     "; disks land at " + quantity(fallSpeed(scene, height), "m/s"),
                 suggestUnit(height, 1e-3, [&](double h) { return !isHigh(scene, h); }));
  if (scene.pour.speed > FASTEST)
    warnings.add("pour.speed", scene.pour.speed, "m/s",
                 number(1e-3 * scene.pour.speed / scene.base.toothWidth()) + " times " +
                     toothKey(scene.base, "width") + " per millisecond",
                 suggestUnit(scene.pour.speed, 1e-3, [](double speed) { return speed <= FASTEST; }));
}

double speedOf(const InitialDisk& disk)
{
  return std::hypot(disk.vx, disk.vy);
}

/// About the first disk of `initial` that is too high, too fast or spins too fast.
void warnOfInitial(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const double slope = std::tan(scene.base.inclination);
  for (std::size_t i = 0; i < scene.initial.size(); ++i)
  {
    const InitialDisk& disk = scene.initial[i];
    const std::string key = "initial." + std::to_string(i);
    const double height = disk.y - slope * disk.x;
    const double rim = std::abs(disk.spin) * scene.species[disk.species].radius;
    const std::size_t before = warnings.size();
    if (isHigh(scene, height))
      warnings.add(key + ".y", disk.y, "m",
                   quantity(height, "m") + " above the base, " + number(height / scene.base.toothWidth()) +
                       " times " + toothKey(scene.base, "width"),
                   suggestUnit(disk.y, 1e-3, [&](double y) { return y > slope * disk.x; }));
    if (speedOf(disk) > FASTEST)
      warnings.add(key + ": the speed (vx, vy) is " + quantity(speedOf(disk), "m/s") + "; is it in mm/s?");
    if (rim > FASTEST)
      warnings.add(key + ".spin", disk.spin, "rad/s", "the rim of the disk moves at " + quantity(rim, "m/s"));
    if (warnings.size() > before)
      return;
  }
}

/// Highest speed of a disk from the start: by pour, fall or initial velocity [m/s].
double fastestStart(const SceneDefinition& scene)
{
  double start = scene.initial.empty() || scene.feed.rate > 0.0
                     ? scene.pour.speed + fallSpeed(scene, scene.pour.drop_height)
                     : 0.0;
  for (const InitialDisk& disk : scene.initial)
    start = std::max(start, speedOf(disk) + fallSpeed(scene, std::abs(disk.y)));
  return start;
}

/// Highest speed of a disk from the drive and falls from tooth to tooth, without collisions [m/s].
double drivenSpeed(const SceneDefinition& scene)
{
  return fallSpeed(scene, relief(scene.base)) + driveBounds(scene.base).speed;
}

/// Highest speed of a disk after the start, whose effect only lasts if there is no drive [m/s].
double lastingSpeed(const SceneDefinition& scene)
{
  return drivenSpeed(scene) + (driveBounds(scene.base).speed > 0.0 ? 0.0 : fastestStart(scene));
}

void warnOfContact(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const double speed = fastestStart(scene) + drivenSpeed(scene);
  const double floor = scene.contact.min_rebound_speed;
  if (speed > 0.0 && floor > speed)
    warnings.add("contact.min_rebound_speed", floor, "m/s",
                 "higher than any speed from fall, pour and drive, " + quantity(speed, "m/s") +
                     ": every contact accelerates the disks",
                 suggestUnit(floor, 1e-3, [&](double v) { return v <= speed; }));
  const double scale = timeScale(scene);
  const double duration = scene.contact.contact_duration;
  if (duration > scale)
    warnings.add(
        "contact.contact_duration", duration, "s",
        "longer than the machine's time scale, " + quantity(scale, "s") + ": almost no contact loses energy",
        suggestUnit(duration, 1e-3, [&](double t) { return t <= scale; }));
}

/// Compares with drive periods or, without a drive, with falls over a tooth. Skipped if those are in doubt.
void warnOfDuration(const SceneDefinition& scene, SceneWarnings& warnings)
{
  if (warnings.size() > 0)
    return;
  const bool driven = scene.base.frequency > 0.0;
  const double period =
      driven ? 1.0 / scene.base.frequency : std::sqrt(scene.base.toothWidth() / scene.gravity);
  if (scene.duration > LONGEST_RUN * period)
    warnings.add("duration", scene.duration, "s",
                 number(scene.duration / 3600.0) + " hours, " + number(scene.duration / period) +
                     (driven ? " drive periods" : " times as long as a fall over a tooth"),
                 1e-3 * scene.duration);
}

std::vector<std::string> warningsOf(const SceneDefinition& scene)
{
  SceneWarnings warnings;
  for (const auto doubt :
       {warnOfNumbers, warnOfRadii, warnOfMasses, warnOfTeeth, warnOfDrive, warnOfAngles, warnOfGravity,
        warnOfLayer, warnOfPour, warnOfInitial, warnOfContact, warnOfDuration})
    doubt(scene, warnings);
  warnOfAccuracy(scene, lastingSpeed(scene), warnings);
  return warnings.take();
}

bool isPlausible(const SceneDefinition& scene)
{
  return shakes(driveBounds(scene.base), scene.gravity) && warningsOf(scene).empty();
}
}  // namespace

std::vector<std::string> implausibilities(const SceneDefinition& scene)
{
  std::vector<std::string> warnings = warningsOf(scene);
  if (!warnings.empty())
    if (const auto slip = unitSlip(scene, isPlausible))
      return {*slip};
  return warnings;
}

}  // namespace ratchet_sieve
