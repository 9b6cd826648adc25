#include "random_scene.h"

#include <numeric>

#include "core/profiles.h"
#include "draws.h"
#include "model/base_motion.h"
#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/core/sizes.h"

namespace ratchet_sieve
{
namespace
{

constexpr double LARGEST_LENGTH = 1e3;    ///< [m]
constexpr double SMALLEST_LENGTH = 1e-9;  ///< [m]
constexpr double LARGEST_SPEED = 1e4;     ///< [m/s]
constexpr double LARGEST_SPIN = 1e9;      ///< [rad/s]
constexpr int MOST_TEETH = 1000000;
constexpr int MOST_CORNERS = 12;
constexpr double LARGEST_SPREAD = 3.0;
constexpr double SHORTEST_STEP = 1e-7;  ///< [s]
constexpr double LONGEST_STEP = 0.1;    ///< [s]
constexpr double MOST_STEPS = 1e3;
constexpr double LARGEST_EXPONENT = 10.0;
constexpr double CUT = 3.0;  ///< of normal and lognormal sizes, in standard deviations

constexpr double LARGEST_PER_TOOTH = 20.0;  ///< radius and tooth height
constexpr double AMPLITUDE_PER_TOOTH = 10.0;
constexpr double DROP_PER_TOOTH = 100.0;
constexpr double SCALES_PER_FALL = 1000.0;
constexpr double TEETH_PER_FALL = 300.0;
constexpr double MOST_PERIODS = 1e4;  ///< of the drive in a run with a height profile
constexpr double TEETH_PER_RUN = 10.0;
constexpr double REST_PER_TIME_SCALE = 0.01;
constexpr double SHORTEST_CONTACT = 1e-4;  ///< of those that can be meant, per time scale
constexpr double RADIUS_PER_TOOTH = 1e-3;
constexpr double FITTING = 0.499;  ///< of the width: radii that leave room to be placed between walls
constexpr double RADIUS_PER_WIDTH = 4e-6;
constexpr double RADIUS_PER_WALL_HEIGHT = 4e-6;
constexpr double WIDEST_WALLED = 1e7;            ///< [m]
constexpr double WIDTHS_PER_WALL_HEIGHT = 12.0;  ///< at most: the default is little more than ten
constexpr double RADII_PER_HEIGHT = 2e5;
constexpr double RADII_PER_TIME_SCALE = 2e4;
constexpr double SURFACE_PER_SPEED = 10.0;
constexpr double MASS_RATIO = 1e4;
constexpr double MOST_DISKS = 30.0;

/// The fastest that the smallest disk is told apart at [m/s].
double fastestSpeed(const SceneDefinition& scene)
{
  return std::min(LARGEST_SPEED, RADII_PER_TIME_SCALE * smallestRadius(scene) / timeScale(scene));
}

/// The default, where it is within the bounds, or another value.
template <typename Draw>
double defaultOr(double default_value, double low, double high, Draw&& draw)
{
  return default_value >= low && default_value <= high && !drawnChance(60) ? default_value : draw();
}

double zeroOrMagnitude(double low, double high)
{
  return drawnChance(85) ? drawnMagnitude(low, high) : 0.0;
}

ContactCoefficients drawnCoefficients()
{
  return {drawnNumber(0.0, 1.0), drawnNumber(0.0, 1e9), drawnNumber(-1.0, 1.0)};
}

/// All together no farther than A may be, and no sharper than a few times as sharp.
void drawOrbit(BaseDefinition& base)
{
  const double widest = std::min(LARGEST_LENGTH, AMPLITUDE_PER_TOOTH * base.toothWidth());
  base.horizontal_amplitude = drawnSigned(-1.0, 1.0) * drawnMagnitude(1e-6 * base.toothWidth(), widest);
  base.horizontal_phase = drawnNumber(-1e6, 1e6);
  for (auto count = drawnIndex<std::size_t>(0, 4); count > 0; --count)
  {
    HarmonicDefinition& harmonic = base.harmonics.emplace_back();
    harmonic.multiple = drawnIndex(2, 6);
    const double least = base.amplitude / (harmonic.multiple * harmonic.multiple);
    harmonic.amplitude = drawnSigned(-least, least);
    harmonic.horizontal_amplitude = drawnSigned(-least, least);
    harmonic.phase = drawnNumber(-1e6, 1e6);
    harmonic.horizontal_phase = drawnNumber(-1e6, 1e6);
  }
}

/// In place of the sawtooth, as wide and as high or deep.
void drawProfile(BaseDefinition& base)
{
  base.profile =
      *rc::gen::resize(rc::kNominalSize, rc::gen::exec(
                                             [&base] {
                                               return test::drawnProfile(base.tooth_width, base.tooth_height,
                                                                         MOST_CORNERS, SMALLEST_LENGTH);
                                             }));
}

void drawBase(SceneDefinition& scene)
{
  BaseDefinition& base = scene.base;
  base.teeth = !drawnChance(80) ? base.teeth : drawnCount(1, drawnChance(20) ? MOST_TEETH : 20);
  base.tooth_width = defaultOr(base.tooth_width, 0.0, 1.0,
                               [&]
                               {
                                 // A disk as small as may be must still fit, beside another.
                                 return drawnMagnitude(4.0 * SMALLEST_LENGTH, LARGEST_LENGTH);
                               });
  const double w = base.tooth_width;
  const double tallest = std::min(LARGEST_LENGTH, LARGEST_PER_TOOTH * w);
  base.tooth_height =
      defaultOr(base.tooth_height, 0.0, tallest, [&] { return zeroOrMagnitude(1e-6 * w, tallest); });
  base.asymmetry = drawnNumber(0.0, 1.0);
  base.inclination = drawnChance(60) ? drawnNumber(-1.5, 1.5) : 0.0;
  const double widest = std::min(LARGEST_LENGTH, AMPLITUDE_PER_TOOTH * w);
  base.amplitude = defaultOr(base.amplitude, 0.0, widest, [&] { return zeroOrMagnitude(1e-6 * w, widest); });
  base.frequency = defaultOr(base.frequency, 0.0, 1e6, [] { return zeroOrMagnitude(1e-3, 1e6); });
  base.phase = drawnNumber(-1e6, 1e6);
  if (drawnChance(30))
    drawProfile(base);
  if (drawnChance(30))
    drawOrbit(base);
  base.drive_frame = drawnOf({DriveFrame::WORLD, DriveFrame::BASE});
}

void drawBoundary(SceneDefinition& scene)
{
  scene.boundary = drawnOf({Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED});
  // Between walls ten times as high as this, no disk is large enough.
  if (scene.base.width() > WIDEST_WALLED && scene.boundary == Boundary::WALLED)
    scene.boundary = Boundary::OPEN;
  if (drawnChance(40))
    scene.base.wall_height =
        std::min(LARGEST_LENGTH, scene.base.width() * drawnMagnitude(1e-3, WIDTHS_PER_WALL_HEIGHT));
}

/// @return the smallest radius that is told apart on the scene's base
double smallestRadiusOn(const SceneDefinition& scene)
{
  const double width = scene.base.width();
  const double walls = scene.boundary == Boundary::WALLED ? WIDTHS_PER_WALL_HEIGHT * width : 0.0;
  return std::max({SMALLEST_LENGTH, RADIUS_PER_TOOTH * scene.base.toothWidth(), RADIUS_PER_WIDTH * width,
                   RADIUS_PER_WALL_HEIGHT * walls});
}

/// A few radii, one of them the species', with any weights but not all 0.
void drawTable(SizeDefinition& size, double radius, double smallest, double largest)
{
  size.radii = {radius};
  for (int count = drawnIndex(0, 6); count > 0; --count)
    size.radii.push_back(drawnMagnitude(smallest, largest));
  std::sort(size.radii.begin(), size.radii.end());
  size.radii.erase(std::unique(size.radii.begin(), size.radii.end()), size.radii.end());
  for (std::size_t i = 0; i < size.radii.size(); ++i)
    size.weights.push_back(drawnChance(70) ? drawnMagnitude(1e-3, 1e9) : 0.0);
  size.weights[drawnIndex<std::size_t>(0, size.weights.size())] = 1.0;
  size.by = drawnOf({SizeShare::NUMBER, SizeShare::MASS});
}

/// Sizes within these bounds [m], and masses within MASS_RATIO of each other.
void drawSize(SpeciesDefinition& species, double smallest, double largest)
{
  SizeDefinition& size = species.size;
  const double r = species.radius;
  // A little within the bounds, for the rounding of radii.
  const double ways = 0.999999 * std::min(1.0 - smallest / r, largest / r - 1.0);
  const double factors = 0.999999 * std::log(std::min(r / smallest, largest / r));
  size.distribution = drawnOf({SizeDistribution::UNIFORM, SizeDistribution::NORMAL,
                               SizeDistribution::LOGNORMAL, SizeDistribution::TABLE});
  switch (size.distribution)
  {
    case SizeDistribution::UNIFORM:
      size.spread = ways * drawnFraction();
      break;
    case SizeDistribution::NORMAL:
      size.spread = ways / CUT * drawnFraction();
      break;
    case SizeDistribution::LOGNORMAL:
      size.spread = std::min(LARGEST_SPREAD, factors / CUT) * drawnFraction();
      break;
    case SizeDistribution::TABLE:
      drawTable(size, r, smallest, largest);
  }
  const Sizes sizes(species);
  const double widest = std::log(std::max(2.0, sizes.largest() / sizes.smallest()));
  size.mass_exponent = drawnNumber(0.0, std::min(LARGEST_EXPONENT, std::log(MASS_RATIO) / widest));
}

void drawSpecies(SceneDefinition& scene)
{
  const BaseDefinition& base = scene.base;
  const double largest =
      std::min({LARGEST_LENGTH, LARGEST_PER_TOOTH * base.toothWidth(), FITTING * base.width()});
  const double smallest = std::min(largest, smallestRadiusOn(scene));
  const double lightest = drawnMagnitude(1e-18, 1e6 / MASS_RATIO);
  const char* const names[] = {"A", "b-2", "true", "1e3"};
  scene.species.resize(drawnIndex<std::size_t>(1, 5));
  for (std::size_t i = 0; i < scene.species.size(); ++i)
  {
    SpeciesDefinition& species = scene.species[i];
    species.name = names[i];
    species.count = drawnCount(0, static_cast<int>(MOST_DISKS) / static_cast<int>(scene.species.size()));
    species.share = drawnChance(50) ? drawnNumber(0.0, 1e9) : 1.0;
    species.radius = drawnMagnitude(smallest, largest);
    species.mass = drawnMagnitude(lightest, MASS_RATIO * lightest);
    if (drawnChance(40))
      drawSize(species, smallest, largest);
    if (drawnChance(70))
      species.contact = drawnCoefficients();
    if (drawnChance(50))
      species.inertia_factor = drawnMagnitude(1e-6, 1.0);
  }
}

void drawPairs(SceneDefinition& scene)
{
  for (std::size_t i = 0; i < scene.species.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (drawnChance(30))
      {
        PairDefinition pair{i, j, contactBetween(scene, i, j)};
        const ContactCoefficients drawn = drawnCoefficients();
        if (drawnChance(60) && scene.contact.min_rebound_speed > 0.0)
          pair.contact.restitution = drawn.restitution;
        if (drawnChance(60))
          pair.contact.friction = drawn.friction;
        if (drawnChance(60))
          pair.contact.tangential_restitution = drawn.tangential_restitution;
        if (drawnChance(50))
          std::swap(pair.first, pair.second);
        scene.pairs.push_back(pair);
      }
}

/// The sharpest that anything is accelerated against the base [m/s^2].
double acceleration(const SceneDefinition& scene)
{
  return scene.gravity + driveBounds(scene.base).acceleration;
}

/// Nothing moves the disks but what they have, and no contact makes energy. What would come to rest in
/// endless contacts is kept from it: by restitution, or by contacts that lose nothing where they follow each
/// other.
void bringToRest(SceneDefinition& scene)
{
  if (drawnChance(50))
  {
    scene.base.amplitude = scene.base.horizontal_amplitude = 0.0;
    scene.base.harmonics.clear();
  }
  else
    scene.base.frequency = 0.0;
  scene.contact.min_rebound_speed = 0.0;
  if (drawnChance(50))
    scene.contact.contact_duration = timeScale(scene) * drawnMagnitude(REST_PER_TIME_SCALE, 1.0);
  const double least = scene.contact.contact_duration > 0.0 ? 0.5 : 1.0;
  for (SpeciesDefinition& species : scene.species)
    species.contact.restitution = std::max(least, species.contact.restitution);
}

void drawContact(SceneDefinition& scene)
{
  ContactDefinition& contact = scene.contact;
  contact.pair_collisions = !drawnChance(30);
  if (drawnChance(30))
    contact.contact_duration =
        drawnChance(50) ? timeScale(scene) * drawnMagnitude(SHORTEST_CONTACT, 1.0) : drawnNumber(0.0, 1e9);
  if (drawnChance(20))
  {
    contact.restitution_speed = drawnMagnitude(1e-9, LARGEST_SPEED);
    contact.restitution_exponent = drawnNumber(0.0, 10.0);
  }
  const double least =
      std::min(LARGEST_SPEED, std::max(1e-9, REST_PER_TIME_SCALE * acceleration(scene) * timeScale(scene)));
  contact.min_rebound_speed = defaultOr(
      contact.min_rebound_speed, least, LARGEST_SPEED,
      [&] { return drawnMagnitude(least, std::max(least, std::min(fastestSpeed(scene), 1e4 * least))); });
  if (drawnChance(15))
    bringToRest(scene);
}

void drawStretch(double width, Stretch& stretch)
{
  if (drawnChance(70))
    return;
  stretch.to = drawnChance(20) ? stretch.to : width * drawnFraction();
  stretch.from = std::min(width, stretch.to) * drawnFraction();
}

void drawPour(SceneDefinition& scene)
{
  const double length = scene.base.toothWidth();
  const double highest = std::min(LARGEST_LENGTH, DROP_PER_TOOTH * length);
  scene.pour.drop_height = defaultOr(scene.pour.drop_height, 0.0, highest,
                                     [&] { return zeroOrMagnitude(1e-3 * length, highest); });
  scene.pour.speed = drawnChance(50) ? drawnNumber(0.0, fastestSpeed(scene)) : 0.0;
  drawStretch(scene.base.width(), scene.pour.stretch);
  drawStretch(scene.base.width(), scene.feed.stretch);
}

/// No height profile of fast drives: each of their periods has many steps.
void drawObserved(SceneDefinition& scene)
{
  const bool profile = scene.base.frequency <= 1e3 && drawnChance(20);
  for (const std::string& name : observableNames())
    if (name == "height_profile" ? profile : drawnChance(30))
      scene.observe.push_back(name);
  if (!profile)
    return;
  scene.height_profile.slice = zeroOrMagnitude(1e-3 * scene.base.tooth_width, LARGEST_LENGTH);
  scene.height_profile.phases = drawnCount(1, 64);
}

/// In the frame of the base, one above the other, so that none overlaps another or the base.
void drawInitial(SceneDefinition& scene, double speed)
{
  const BaseDefinition& base = scene.base;
  const FrameOfBase frame = BaseMotion(base).at(0.0);
  double n = base.highest();
  const double highest = RADII_PER_HEIGHT * smallestRadius(scene);
  for (auto count = drawnIndex<std::size_t>(1, 7); count > 0 && (scene.initial.empty() || n < highest);
       --count)
  {
    InitialDisk& disk = scene.initial.emplace_back();
    disk.species = drawnIndex<std::size_t>(0, scene.species.size());
    const double radius = scene.species[disk.species].radius;
    const double margin = scene.boundary == Boundary::PERIODIC ? 1e-6 * base.width() : radius;
    n += radius * (1.001 + zeroOrMagnitude(1e-3, 10.0));
    const double s = margin + (base.width() - 2.0 * margin) * (0.001 + 0.998 * drawnFraction());
    const Eigen::Vector2d place = frame.positionOutOf({s, n});
    disk.x = place.x();
    disk.y = place.y();
    n += radius;
    disk.vx = drawnSigned(-speed, speed);
    disk.vy = drawnSigned(-speed, speed);
    const double spin = std::min(LARGEST_SPIN, SURFACE_PER_SPEED * speed / radius);
    disk.spin = drawnSigned(-spin, spin);
  }
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;
}

/// The fall from the pour to the base, and a few teeth at the fastest speed there is.
void drawDuration(SceneDefinition& scene)
{
  const double time_scale = timeScale(scene);
  const double drop = scene.pour.drop_height;
  const double impact = std::sqrt(scene.pour.speed * scene.pour.speed + 2.0 * scene.gravity * drop);
  const double fall = impact > 0.0 && scene.initial.empty() ? 2.0 * drop / (impact + scene.pour.speed) : 0.0;
  double fastest = std::max({impact, driveBounds(scene.base).speed, scene.contact.min_rebound_speed,
                             scene.base.toothWidth() / time_scale});
  for (const InitialDisk& disk : scene.initial)
    fastest = std::max(fastest, std::hypot(disk.vx, disk.vy));
  // A long fall between fast strokes would be nothing but turns of the drive, and one beside walls, rebounds.
  const double longest =
      std::min(SCALES_PER_FALL * time_scale,
               TEETH_PER_FALL * scene.base.toothWidth() / std::max(impact, scene.contact.min_rebound_speed));
  scene.duration = std::min(
      1e9, std::min(fall, longest) + TEETH_PER_RUN * drawnFraction() * scene.base.toothWidth() / fastest);
  // A profile divides each flight at each period of the drive, also on a base that is at rest.
  if (std::count(scene.observe.begin(), scene.observe.end(), "height_profile") > 0)
    scene.duration = std::min(scene.duration, MOST_PERIODS / scene.base.frequency);
  scene.settle = drawnOf({0.0, 0.0, 0.5, 1.0}) * scene.duration;
  if (scene.duration > 0.0 && drawnChance(20))
  {
    scene.feed.rate = std::min(1e6, 0.5 * MOST_DISKS * drawnFraction() / scene.duration);
    scene.feed.even = drawnChance(2);
  }
}

/// By steps of any length that is legal, as long as there are not too many.
void drawMethod(SceneDefinition& scene)
{
  const double step = std::clamp(timeScale(scene) * drawnMagnitude(1e-3, 1.0), SHORTEST_STEP, LONGEST_STEP);
  if (!drawnChance(15) || scene.duration > MOST_STEPS * step)
    return;
  scene.accuracy.method = Method::STEPS;
  scene.accuracy.step = step;
}

double sumOfShares(const SceneDefinition& scene)
{
  return std::accumulate(scene.species.begin(), scene.species.end(), 0.0,
                         [](double sum, const SpeciesDefinition& species) { return sum + species.share; });
}

}  // namespace

SceneDefinition drawnRunnableScene()
{
  const bool placed = drawnChance(25);
  SceneDefinition scene;
  drawBase(scene);
  drawBoundary(scene);
  scene.gravity = drawnChance(50) ? zeroOrMagnitude(1e-6, 1e4) : scene.gravity;
  drawSpecies(scene);
  drawContact(scene);
  drawPairs(scene);
  drawPour(scene);
  drawObserved(scene);
  if (placed)
    drawInitial(scene, std::min(fastestSpeed(scene),
                                scene.base.toothWidth() / timeScale(scene) * drawnMagnitude(1e-3, 1e3)));
  drawDuration(scene);
  drawMethod(scene);
  if (sumOfShares(scene) <= 0.0)
    scene.feed.rate = 0.0;
  scene.seed = *rc::gen::arbitrary<std::uint64_t>();
  return scene;
}

}  // namespace ratchet_sieve
