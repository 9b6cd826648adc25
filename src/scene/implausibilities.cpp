#include "ratchet_sieve/scene/implausibilities.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/sizes.h"
#include "scene_rules.h"
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
constexpr int FEW_PHASES = 8;             ///< of the drive, at which an even feed's disks enter

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
    const bool vary = scene.species[i].size.vary();
    const std::string figure =
        (vary ? "the largest disk's diameter, " : "a disk's diameter, ") + quantity(2.0 * radius, "m") +
        (2.0 * radius > base.width() ? ", is larger than the base's width, " + quantity(base.width(), "m")
                                     : ", is larger than a tooth, " + toothKey(base, "width") + " = " +
                                           quantity(base.toothWidth(), "m"));
    const auto smaller = suggestUnit(
        radius, 1e-3, [&](double r) { return 2.0 * r <= room && 200.0 * r >= base.toothWidth(); });
    if (vary)
      warnings.add(speciesKey(i, "size") + ": " + figure + (smaller ? "; are its radii in mm?" : ""));
    else
      warnings.add(speciesKey(i, "radius"), radius, "m", figure, smaller);
  }
}

/// Sieve analyses are often written down as the share that passes each sieve, which ends with all.
bool looksCumulative(const std::vector<double>& weights)
{
  const auto not_more = [](double a, double b) { return a >= b && a > 0.0; };
  return weights.size() > 2 && (weights.back() == 1.0 || weights.back() == 100.0) &&
         weights.end()[-2] > 0.0 &&
         std::adjacent_find(weights.begin(), weights.end(), not_more) == weights.end();
}

void warnOfTables(const SceneDefinition& scene, SceneWarnings& warnings)
{
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    const std::vector<double>& weights = scene.species[i].size.weights;
    if (looksCumulative(weights))
      warnings.add(
          speciesKey(i, "size.weights") + " grow to " + number(weights.back()) +
          ", as cumulative shares do; each weight is the share between its radius and the one before, and "
          "these sum to " +
          number(std::accumulate(weights.begin(), weights.end(), 0.0)));
  }
}

struct SizedDisk
{
  double mass = 0.0;    ///< [kg]
  double radius = 0.0;  ///< [m]
};

/// The smallest or the largest disk: the mass is a power of the radius.
SizedDisk densestDisk(const SpeciesDefinition& species)
{
  const Sizes sizes(species);
  const SizedDisk smallest{species.massOf(sizes.smallest()), sizes.smallest()};
  const SizedDisk largest{species.massOf(sizes.largest()), sizes.largest()};
  return smallest.mass / ballVolume(smallest.radius) > largest.mass / ballVolume(largest.radius) ? smallest
                                                                                                 : largest;
}

void warnOfMass(const SceneDefinition& scene, std::size_t index, SceneWarnings& warnings)
{
  const SpeciesDefinition& species = scene.species[index];
  const SizedDisk disk = densestDisk(species);
  const auto dense = [](double m, double r) { return m > DENSEST_DISK * ballVolume(r); };
  if (!dense(disk.mass, disk.radius))
    return;
  const auto lighter = suggestUnit(
      species.mass, 1e-3, [&](double m) { return !dense(disk.mass * (m / species.mass), disk.radius); });
  const auto larger = suggestUnit(species.radius, 1e3,
                                  [&](double r)
                                  {
                                    const double scale = r / species.radius;
                                    return species.size.radii.empty() &&
                                           !dense(disk.mass, disk.radius * scale) &&
                                           2.0 * Sizes(species).largest() * scale <= valley(scene.base);
                                  });
  const bool by_radius = larger && !lighter;
  const std::string mass_key = speciesKey(index, "mass");
  const std::string radius_key = speciesKey(index, "radius");
  const std::string given = species.size.vary()
                                ? speciesKey(index, "size") + " a disk of radius " +
                                      quantity(disk.radius, "m") + " has " + quantity(disk.mass, "kg") + ":"
                            : by_radius ? mass_key + " = " + quantity(disk.mass, "kg")
                                        : radius_key + " = " + quantity(disk.radius, "m");
  const std::string figure = "with " + given + " the density of a sphere would be " +
                             quantity(disk.mass / ballVolume(disk.radius), "kg/m^3") +
                             "; osmium has 22590 kg/m^3";
  if (by_radius)
    warnings.add(radius_key, species.radius, "m", figure, larger);
  else
    warnings.add(mass_key, species.mass, "kg", figure, lighter);
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

/// The number of phases of the drive at which an even feed's disks enter, if they are few: f / rate is a
/// fraction of this denominator, to within a period over the whole run.
std::optional<int> phasesOfEvenFeed(const SceneDefinition& scene)
{
  if (!scene.feed.even || scene.feed.rate <= 0.0 || scene.base.frequency <= 0.0)
    return std::nullopt;
  for (int phases = 1; phases <= FEW_PHASES; ++phases)
  {
    const double periods = phases * scene.base.frequency / scene.feed.rate;
    const double drift = std::abs(periods - std::round(periods)) * scene.feed.rate / phases;
    if (drift * scene.duration < 1.0)
      return phases;
  }
  return std::nullopt;
}

void warnOfFeed(const SceneDefinition& scene, SceneWarnings& warnings)
{
  const Stretch& stretch = scene.feed.stretch;
  if (scene.feed.rate == 0.0 && (stretch.from > 0.0 || std::isfinite(stretch.to)))
    warnings.add("feed.rate", scene.feed.rate, "1/s", "feed.from and feed.to have no effect");
  if (const auto phases = phasesOfEvenFeed(scene))
    warnings.add("feed.rate", scene.feed.rate, "1/s",
                 "with feed.even, disks enter at " +
                     (*phases == 1 ? "one phase" : number(*phases) + " phases") + " of the drive of " +
                     quantity(scene.base.frequency, "Hz") +
                     ", on which results depend; without it, at random times");
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
  for (const auto doubt : {warnOfNumbers, warnOfRadii, warnOfTables, warnOfMasses, warnOfTeeth, warnOfDrive,
                           warnOfAngles, warnOfGravity, warnOfLayer, warnOfFeed, warnOfPour, warnOfInitial,
                           warnOfContact, warnOfDuration, warnOfLift})
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
