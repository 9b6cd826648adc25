#include "ratchet_sieve/scene/scene_file.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "plausibility.h"
#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/sizes.h"
#include "ratchet_sieve/scene/shown_text.h"
#include "schema.h"

// Rules on scenes that are valid but could not be built. Most ratios hold for machines of any size.
namespace ratchet_sieve
{
namespace
{

constexpr double DENSEST = 1e7;  ///< as spheres; osmium: 2.3e4, the paper's A: 2.4e6 [kg/m^3]
constexpr double HIGH = 1.0;     ///< drop or layer, if it is large in terms of the scene as well [m]

constexpr int FEW_PHASES = 8;            ///< of the drive, at which an even feed's disks enter
constexpr double TIME_OF_A_STEP = 3e-8;  ///< processor time for one disk, in 2026 [s]

// Limits of how far a disk moves within a step, in smallest diameters, from docs/accuracy.md: in a layer
// steps of 1.3 are good enough; with a violent drive and steps of 1.5 energies are a third too high. Below
// 0.01 the exact method, events, is faster.
constexpr double FARTHEST = 1.4;
constexpr double NEAREST = 0.01;

// Limits of the rebound floor: below these, drifts depend on it by less than their errors.
constexpr double MOST_OF_DRIVE = 1.0 / 3.0;  ///< of the base's largest speed
constexpr double MOST_RISE = 0.18;           ///< of a rebound at the floor, in smallest radii

/// From the lowest to the highest point of the teeth [m].
double relief(const BaseDefinition& base)
{
  return base.depth() + base.highest();
}

/// The width of a tooth as a subject, or its height: the key, or the profile's, which has no key of its own.
/// A profile whose width is mended is in mm as a whole.
Subject toothSize(BaseDefinition& base, bool width)
{
  const char* const name = width ? "width" : "height";
  if (base.profile.empty())
    return {std::string("base.tooth_") + name, width ? base.tooth_width : base.tooth_height, "m"};
  std::vector<double*> parts;
  for (OutlineCorner& corner : base.profile)
  {
    if (width)
      parts.push_back(&corner.s);
    parts.push_back(&corner.n);
  }
  return {std::string("base.profile's ") + name, width ? base.toothWidth() : relief(base), "m", parts};
}

/// After a fall from rest [m/s].
double fallSpeed(const SceneDefinition& scene, double height)
{
  return std::sqrt(2.0 * scene.gravity * height);
}

bool pours(const SceneDefinition& scene)
{
  return scene.initial.empty() || scene.feed.any();
}

double speedOf(const InitialDisk& disk)
{
  return std::hypot(disk.vx, disk.vy);
}

/// Highest speed of a disk from the start: by pour, fall or initial velocity [m/s].
double fastestStart(const SceneDefinition& scene)
{
  double start = pours(scene) ? scene.pour.speed + fallSpeed(scene, scene.pour.drop_height) : 0.0;
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

/// Sieve analyses are often written down as the share that passes each sieve, which ends with all.
bool looksCumulative(const std::vector<double>& weights)
{
  const auto not_more = [](double a, double b) { return a >= b && a > 0.0; };
  return weights.size() > 2 && (weights.back() == 1.0 || weights.back() == 100.0) &&
         weights.end()[-2] > 0.0 &&
         std::adjacent_find(weights.begin(), weights.end(), not_more) == weights.end();
}

void judgeDensity(SpeciesDefinition& species, const std::string& key, double room, Plausibility& is)
{
  const Sizes sizes(species);
  const auto as_sphere = [&](double radius) { return species.massOf(radius) / ballVolume(radius); };
  // The smallest or the largest disk: the mass is a power of the radius.
  const double radius =
      as_sphere(sizes.smallest()) > as_sphere(sizes.largest()) ? sizes.smallest() : sizes.largest();
  const double density = as_sphere(radius);
  const bool small =
      MILLI * density > DENSEST && species.size.radii.empty() && 2.0 * sizes.largest() / MILLI <= room;
  is.rule("dense-disk",
          small ? Subject(key + "radius", species.radius, "m") : Subject(key + "mass", species.mass, "kg"),
          density, DENSEST,
          "a disk of radius # and mass # would have the density # as a sphere; osmium has 22590 kg/m^3",
          {{radius, "m"}, {species.massOf(radius), "kg"}, {density, "kg/m^3"}},
          {small ? 1.0 / MILLI : MILLI});
}

void judgeDisks(SceneDefinition& scene, Plausibility& is)
{
  const double tooth_width = scene.base.toothWidth();
  const double width = scene.base.width();
  is.rule("no-disks", {}, when(disksAtStart(scene) == 0 && !scene.feed.any()), 0.0,
          "no disks: every species.N.count is 0, initial is empty and feed has neither a rate nor a disk; a "
          "density, if given, is too small: the base is # wide and the largest diameter is #",
          {{width, "m"}, {largestDiameter(scene), "m"}});
  const double room = relief(scene.base) > 0.0 ? tooth_width : width;
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    SpeciesDefinition& species = scene.species[i];
    const std::string key = "species." + std::to_string(i) + ".";
    const double diameter = 2.0 * Sizes(species).largest();
    is.rule("large-disk",
            species.size.vary() ? Subject(key + "size") : Subject(key + "radius", species.radius, "m"),
            diameter / room, 1.0,
            "the largest diameter, #, is larger than the room for a disk, #: a tooth's width, or a flat "
            "base's",
            {{diameter, "m"}, {room, "m"}}, {MILLI});
    const std::vector<double>& weights = species.size.weights;
    is.rule(
        "cumulative-weights", Subject(key + "size.weights"), when(looksCumulative(weights)), 0.0,
        "they grow to #, as cumulative shares do; each weight is the share between its radius and the one "
        "before, and these sum to #",
        {{weights.empty() ? 0.0 : weights.back()}, {std::accumulate(weights.begin(), weights.end(), 0.0)}});
    judgeDensity(species, key, room, is);
  }
}

void judgeTeeth(SceneDefinition& scene, Plausibility& is)
{
  BaseDefinition& base = scene.base;
  const double diameter = largestDiameter(scene);
  const double width = base.toothWidth();
  const double height = relief(base);
  is.rule("wide-teeth", toothSize(base, true), width / diameter, 500.0,
          "# times the diameter of the largest disks, #", {{width / diameter}, {diameter, "m"}}, {MILLI});
  is.rule("tall-teeth", toothSize(base, false), height / width, 10.0, "# times a tooth's width, #",
          {{height / width}, {width, "m"}}, {MILLI});
}

/// The number of phases of the drive at which an even feed's disks enter, if they are few, or else 0: f /
/// rate is a fraction of this denominator, to within a period over the whole run.
int phasesOfEvenFeed(const SceneDefinition& scene)
{
  if (!scene.feed.even || scene.feed.rate <= 0.0 || scene.base.frequency <= 0.0)
    return 0;
  for (int phases = 1; phases <= FEW_PHASES; ++phases)
  {
    const double periods = phases * scene.base.frequency / scene.feed.rate;
    const double drift = std::abs(periods - std::round(periods)) * scene.feed.rate / phases;
    if (drift * scene.duration < 1.0)
      return phases;
  }
  return 0;
}

void judgeLayer(SceneDefinition& scene, Plausibility& is)
{
  const double width = scene.base.width();
  const double diameter = largestDiameter(scene);
  const double disks = static_cast<double>(disksAtStart(scene));
  const double layer = settledLayer(scene);
  const bool tall = layer > HIGH && layer > 100.0 * diameter;
  // A single disk in a narrow machine is not a layer.
  is.rule(
      "thick-layer", {}, when(tall || (layer > 2.0 * width && layer > diameter && disks > 1.0)), 0.0,
      "the counts of all species sum to # disks: at rest a layer # thick, # of the largest diameters, on a "
      "base # wide; did you mean a smaller density, smaller counts or larger radii?",
      {{disks}, {layer, "m"}, {layer / diameter}, {width, "m"}});

  const Stretch& stretch = scene.feed.stretch;
  const Subject rate =
      scene.feed.disks.empty() ? Subject("feed.rate", scene.feed.rate, "1/s") : Subject("feed.disks");
  const double growth = feedGrowth(scene) * timeScale(scene) / diameter;
  is.rule("fast-feed", rate, growth, 1.0,
          "raises the layer by #, # of the largest diameters within the machine's time scale, #",
          {{feedGrowth(scene), "m/s"}, {growth}, {timeScale(scene), "s"}}, {MILLI});
  is.rule("unused-feed", rate, when(!scene.feed.any() && (stretch.from > 0.0 || std::isfinite(stretch.to))),
          0.0, "feed.from and feed.to have no effect");
  const double late =
      static_cast<double>(std::count_if(scene.feed.disks.begin(), scene.feed.disks.end(),
                                        [&](const FedDisk& disk) { return disk.time > scene.duration; }));
  is.rule("late-feed", Subject("feed.disks"), late, 0.0, "# disk(s) of # are to be fed after the duration, #",
          {{late}, {static_cast<double>(scene.feed.disks.size())}, {scene.duration, "s"}});
  const double phases = phasesOfEvenFeed(scene);
  is.rule("even-feed", rate, phases, 0.0,
          "with feed.even, disks enter at # phase(s) of the drive of #, on which results depend; without it, "
          "at random times",
          {{phases}, {scene.base.frequency, "Hz"}});
}

/// Whether a height is large, also in teeth.
double tall(const SceneDefinition& scene, double height)
{
  return when(height > HIGH && height > 20.0 * scene.base.toothWidth());
}

void judgePour(SceneDefinition& scene, Plausibility& is)
{
  if (!pours(scene))
    return;
  PourDefinition& pour = scene.pour;
  const double width = scene.base.toothWidth();
  is.rule("high-drop", Subject("pour.drop_height", pour.drop_height, "m"), tall(scene, pour.drop_height), 0.0,
          "# times a tooth's width; disks land at #",
          {{pour.drop_height / width}, {fallSpeed(scene, pour.drop_height), "m/s"}}, {MILLI});
  is.rule("fast-pour", Subject("pour.speed", pour.speed, "m/s"), pour.speed, FASTEST,
          "# times a tooth's width per millisecond", {{MILLI * pour.speed / width}}, {MILLI});
}

/// About the first disk of `initial` that is too high, too fast or spins too fast.
void judgeInitial(SceneDefinition& scene, Plausibility& is)
{
  const double width = scene.base.toothWidth();
  const std::size_t before = is.lines().size();
  for (std::size_t i = 0; i < scene.initial.size() && is.lines().size() == before; ++i)
  {
    InitialDisk& disk = scene.initial[i];
    const std::string key = "initial." + std::to_string(i);
    const double height = disk.y - std::tan(scene.base.inclination) * disk.x;
    const double rim = std::abs(disk.spin) * scene.species[disk.species].radius;
    is.rule("high-disk", Subject(key + ".y", disk.y, "m"), tall(scene, height), 0.0,
            "# above the base, # times a tooth's width", {{height, "m"}, {height / width}}, {MILLI});
    is.rule("fast-disk", Subject(key), speedOf(disk), FASTEST, "the speed (vx, vy) is #; is it in mm/s?",
            {{speedOf(disk), "m/s"}});
    is.rule("fast-spin", Subject(key + ".spin", disk.spin, "rad/s"), rim, FASTEST,
            "the rim of the disk moves at #", {{rim, "m/s"}});
  }
}

void judgeTimes(SceneDefinition& scene, Plausibility& is)
{
  ContactDefinition& contact = scene.contact;
  const double speed = fastestStart(scene) + drivenSpeed(scene);
  is.rule("fast-rebound", Subject("contact.min_rebound_speed", contact.min_rebound_speed, "m/s"),
          when(speed > 0.0 && contact.min_rebound_speed > speed), 0.0,
          "higher than any speed from fall, pour and drive, #: every contact accelerates the disks",
          {{speed, "m/s"}}, {MILLI});
  const double scale = timeScale(scene);
  is.rule("long-contact", Subject("contact.contact_duration", contact.contact_duration, "s"),
          contact.contact_duration, scale,
          "longer than the machine's time scale, #: almost no contact loses energy", {{scale, "s"}}, {MILLI});

  const bool driven = scene.base.frequency > 0.0;
  const double period =
      driven ? 1.0 / scene.base.frequency : std::sqrt(scene.base.toothWidth() / scene.gravity);
  const double periods = scene.duration / period;
  // Skipped if the drive or the teeth are in doubt.
  if (is.lines().empty())
    is.rule("long-run", Subject("duration", scene.duration, "s"), periods, 1e6,
            driven ? "# hours, # drive periods" : "# hours, # times as long as a fall over a tooth",
            {{scene.duration / 3600.0}, {periods}}, {MILLI});
}

void judgeMethod(SceneDefinition& scene, Plausibility& is)
{
  double& step = scene.accuracy.step;
  const Subject subject("accuracy.step", step, "s");
  const bool steps = scene.accuracy.method == Method::STEPS;
  const bool pairs = scene.contact.pair_collisions;
  const double speed = lastingSpeed(scene);
  const double time = 2.0 * smallestRadius(scene) / speed;
  is.rule("long-step", subject, steps && pairs ? step : 0.0, FARTHEST * time,
          "a disk moves by up to # within a step, # of the smallest diameters: many contacts are missed; use "
          "at most #",
          {{speed * step, "m"}, {step / time}, {FARTHEST * time, "s"}});
  is.rule("short-step", subject, when(steps && pairs && speed > 0.0 && step < NEAREST * time), 0.0,
          "# steps per simulated second take about # of processor time: slower than method events, which is "
          "exact",
          {{1.0 / step}, {std::ceil(TIME_OF_A_STEP / step * static_cast<double>(disksAtStart(scene))), "s"}},
          {1.0 / MILLI});
  is.rule("unused-steps", Subject("accuracy.method = steps"), when(steps && !pairs), 0.0,
          "has no effect, because contact.pair_collisions is false");
  is.rule("unused-step", subject, when(!steps && step != AccuracyDefinition().step), 0.0,
          "has no effect, because accuracy.method is events");
}

void judgeCertainty(SceneDefinition& scene, Plausibility& is)
{
  AccuracyDefinition& accuracy = scene.accuracy;
  const Subject mean("accuracy.mean_vx", accuracy.mean_vx, "m/s");
  const Subject quality("accuracy.quality", accuracy.quality, "");
  const bool periodic = scene.boundary == Boundary::PERIODIC;
  const double speed = lastingSpeed(scene);
  is.rule("coarse-mean", mean, accuracy.mean_vx, 0.2 * speed, "too coarse for disks whose speeds reach #",
          {{speed, "m/s"}}, {MILLI});
  is.rule("mean-of-none", mean, empties(scene) ? accuracy.mean_vx : 0.0, 0.0,
          "an open base that is not fed empties, and has no steady <V_x>; boundary must be periodic or "
          "feed.rate above 0");
  is.rule("quality-of-none", quality, periodic ? accuracy.quality : 0.0, 0.0,
          "cannot be reached, because no disk leaves a periodic base; boundary must be open or walled");
  is.rule("quality-of-one", quality, !periodic && scene.species.size() < 2 ? accuracy.quality : 0.0, 0.0,
          "cannot be reached, because Q compares species; there must be two or more");
}

/// Of a rebound floor that itself drives the disks. The number to set has two digits and is not above the
/// limit.
void judgeFloor(SceneDefinition& scene, Plausibility& is)
{
  double radius = INFINITY;
  for (const SpeciesDefinition& species : scene.species)
    radius = std::min(radius, Sizes(species).meanRadius());  // the few smallest of many decide no drift
  const double speed = driveBounds(scene.base).speed;
  const double by_drive = speed > 0.0 ? MOST_OF_DRIVE * speed : INFINITY;
  const double by_rise = scene.gravity > 0.0 ? std::sqrt(2.0 * scene.gravity * MOST_RISE * radius) : INFINITY;
  const double most = std::min(by_drive, by_rise);
  const double digit = std::pow(10.0, std::floor(std::log10(most)) - 1.0);
  is.rule("high-floor", Subject("contact.min_rebound_speed", scene.contact.min_rebound_speed, "m/s"),
          scene.contact.min_rebound_speed, most,
          by_drive < by_rise
              ? "the base itself moves at # at most: slow contacts drive the disks; use at most #"
              : "too much for disks of radius #: slow contacts drive them; use at most #",
          {by_drive < by_rise ? Figure{speed, "m/s"} : Figure{radius, "m"},
           {digit * std::floor(most / digit), "m/s"}});
}

/// @param scene is changed on the way, and is in the end as it was
std::vector<std::string> linesOf(SceneDefinition& scene, bool with_suggestions)
{
  const auto count = [&scene] { return linesOf(scene, false).size(); };
  Plausibility is(with_suggestions ? Plausibility::Count(count) : nullptr);
  for (const auto judge : {judgeDisks, judgeTeeth, judgeDrive, judgeAngles, judgeLayer, judgePour,
                           judgeInitial, judgeTimes, judgeMethod, judgeCertainty})
    judge(scene, is);
  return is.lines();
}

/// Whether nothing is implausible, and the drive is strong enough to throw disks up, or nearly so.
bool isPlausible(SceneDefinition scene)
{
  return driveBounds(scene.base).acceleration >= 0.5 * scene.gravity && linesOf(scene, false).empty();
}
}  // namespace

std::vector<std::string> implausibilities(const SceneDefinition& scene)
{
  SceneDefinition judged = scene;
  Plausibility is(nullptr);
  std::vector<std::string>& lines = is.lines() = linesOf(judged, true);
  if (!lines.empty())
    if (const auto slip = unitSlip(scene, isPlausible))
      return {withId(*slip, "units")};
  // Where a value is in doubt, so are the limits of the floor.
  if (std::none_of(lines.begin(), lines.end(), [](auto& line) { return line.find("did you") != line.npos; }))
    judgeFloor(judged, is);
  return is.lines();
}

}  // namespace ratchet_sieve
