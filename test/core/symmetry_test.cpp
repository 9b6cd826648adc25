#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "constants.h"
#include "profiles.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

/// The symmetries of the equations of motion must be symmetries of the engine.
namespace ratchet_sieve
{
namespace
{

/// `count` disks, the species in turn, in two rows well apart, each with its own velocity and spin. Disks
/// that nearly touch would collide at once, in an order determined by rounding.
SceneDefinition stirred(SceneDefinition scene, int count, unsigned seed = 1)
{
  std::mt19937 random(seed);
  const auto uniform = [&random](double largest) { return largest * (random() / 2147483648.0 - 1.0); };
  const double spacing = scene.base.width() / count;
  const double sine = std::sin(scene.base.inclination), cosine = std::cos(scene.base.inclination);
  for (int k = 0; k < count; ++k)
  {
    const double s = (k + 0.5) * spacing, n = k % 2 == 0 ? 0.015 : 0.022;
    const double vx = uniform(0.3), vy = uniform(0.3), spin = uniform(100.0);
    scene.initial.push_back(
        {k / 2 % scene.species.size(), s * cosine - n * sine, s * sine + n * cosine, vx, vy, spin});
  }
  return scene;
}

/// The first collisions of a scene. The order of i and j in a pair is ignored: the tangential impulse has the
/// same sign for both.
std::vector<CollisionRecord> firstCollisions(const SceneDefinition& scene, std::size_t count)
{
  Simulation simulation(scene);
  std::vector<CollisionRecord> records;
  simulation.observeCollisions(
      [&](CollisionRecord record)
      {
        if (record.j && *record.j < record.i)
          std::swap(*record.j, record.i);
        records.push_back(record);
      });
  while (records.size() < count)
    simulation.advanceTo(simulation.time() + 0.01);
  records.resize(count);
  return records;
}

/// Initial rounding errors, 1e-17 s of the first contact times and 1e-15 m/s of speeds, grow from contact to
/// contact: to at most 2e-11 over the compared contacts (see COMPARED), and to 1e-8 and more after three
/// times as many. In s, m/s, and N s per kg of the first species.
constexpr double GROWN_ROUNDING = 1e-10;

void expectSame(const std::vector<CollisionRecord>& ones, const std::vector<CollisionRecord>& others,
                double tangent_sign, double mass)
{
  ASSERT_EQ(ones.size(), others.size());
  for (std::size_t k = 0; k < ones.size(); ++k)
  {
    const CollisionRecord& one = ones[k];
    const CollisionRecord& other = others[k];
    ASSERT_EQ(one.i, other.i) << "collision " << k;
    ASSERT_EQ(one.j, other.j) << "collision " << k;
    ASSERT_EQ(one.kind, other.kind) << "collision " << k;
    ASSERT_NEAR(one.time, other.time, GROWN_ROUNDING) << "collision " << k;
    ASSERT_NEAR(one.normal_speed, other.normal_speed, GROWN_ROUNDING) << "collision " << k;
    ASSERT_NEAR(one.normal_impulse, other.normal_impulse, mass * GROWN_ROUNDING) << "collision " << k;
    ASSERT_NEAR(one.tangential_impulse, tangent_sign * other.tangential_impulse, mass * GROWN_ROUNDING)
        << "collision " << k;
  }
}

struct Compared
{
  const char* name;
  bool pairs;
  Boundary boundary;
  double inclination;
  int disks;
  std::size_t collisions;
  double wall_height = 0.0;
  bool orbit = false;
  DriveFrame drive_frame = DriveFrame::WORLD;
  bool profile = false;
};

/// Number of collisions that are compared: five per disk without disk-disk collisions, and one and a half
/// with them. Between a wall and a slope a disk has many contacts, and its errors grow fast.
const Compared COMPARED[] = {
    {"single", false, Boundary::PERIODIC, 0.0, 50, 240},
    {"single, inclined", false, Boundary::PERIODIC, 0.1, 50, 240},
    {"mixture", true, Boundary::PERIODIC, 0.0, 100, 160},
    {"mixture, inclined", true, Boundary::PERIODIC, 0.1, 100, 160},
    {"walled", true, Boundary::WALLED, 0.1, 100, 100},
    {"walled, low", true, Boundary::WALLED, 0.1, 100, 100, 0.01},
    {"open", true, Boundary::OPEN, 0.1, 100, 100},
    {"single, orbit", false, Boundary::PERIODIC, 0.1, 50, 240, 0.0, true},
    {"mixture, orbit", true, Boundary::PERIODIC, 0.1, 100, 160, 0.0, true},
    {"walled, orbit", true, Boundary::WALLED, 0.1, 100, 100, 0.0, true},
    {"open, orbit", true, Boundary::OPEN, 0.1, 100, 100, 0.0, true},
    {"deck", true, Boundary::PERIODIC, 0.3, 100, 160, 0.0, true, DriveFrame::BASE},
    {"deck, walled", true, Boundary::WALLED, 0.3, 100, 100, 0.0, true, DriveFrame::BASE},
    {"profile", true, Boundary::PERIODIC, 0.1, 100, 100, 0.0, false, DriveFrame::WORLD, true},
    {"profile, single", false, Boundary::PERIODIC, 0.1, 50, 100, 0.0, true, DriveFrame::BASE, true},
    {"profile, walled", true, Boundary::WALLED, 0.1, 100, 100, 0.0, true, DriveFrame::BASE, true},
    {"profile, open", true, Boundary::OPEN, 0.1, 100, 100, 0.0, true, DriveFrame::BASE, true}};

SceneDefinition sceneOf(const Compared& compared)
{
  SceneDefinition scene = compared.pairs ? test::mixture(0) : test::singleParticles(0);
  scene.boundary = compared.boundary;
  scene.base.inclination = compared.inclination;
  scene.base.wall_height = compared.wall_height;
  scene.base.drive_frame = compared.drive_frame;
  if (compared.profile)
    scene.base.profile = test::castle();
  return stirred(compared.orbit ? test::onAnOrbit(scene) : scene, compared.disks);
}

/// The base mirrored, s -> W - s, and its drive with it. It turns about the foot at s = 0, which is the other
/// foot after mirroring, so that in the world x -> W cos(theta) - x and y -> y - W sin(theta).
SceneDefinition mirrored(SceneDefinition scene)
{
  BaseDefinition& base = scene.base;
  base.asymmetry = 1.0 - base.asymmetry;
  std::reverse(base.profile.begin(), base.profile.end());
  for (OutlineCorner& corner : base.profile)
    corner.s = base.tooth_width - corner.s;
  base.horizontal_amplitude = -base.horizontal_amplitude;
  for (HarmonicDefinition& harmonic : base.harmonics)
    harmonic.horizontal_amplitude = -harmonic.horizontal_amplitude;
  for (InitialDisk& disk : scene.initial)
  {
    disk.x = base.width() * std::cos(base.inclination) - disk.x;
    disk.y -= base.width() * std::sin(base.inclination);
    disk.vx = -disk.vx;
    disk.spin = -disk.spin;
  }
  base.inclination = -base.inclination;
  return scene;
}

CollisionKind mirrored(CollisionKind kind)
{
  return kind == CollisionKind::LEFT_SLOPE    ? CollisionKind::RIGHT_SLOPE
         : kind == CollisionKind::RIGHT_SLOPE ? CollisionKind::LEFT_SLOPE
                                              : kind;
}

TEST(Symmetry, AMirroredMachineDoesTheSameMirrored)
{
  for (const Compared& compared : COMPARED)
  {
    SCOPED_TRACE(compared.name);
    const SceneDefinition scene = sceneOf(compared);
    auto other = firstCollisions(mirrored(scene), compared.collisions);
    for (CollisionRecord& record : other)
      record.kind = mirrored(record.kind);
    expectSame(firstCollisions(scene, compared.collisions), other, -1.0, scene.species[0].mass);
  }
}

/// Without gravity nothing but the base has a direction: turned with its drive, the whole run is turned.
TEST(Symmetry, ADeckTurnedWithItsDriveDoesTheSameTurned)
{
  for (const Compared& compared : COMPARED)
  {
    if (compared.drive_frame != DriveFrame::BASE)
      continue;
    SCOPED_TRACE(compared.name);
    SceneDefinition scene = sceneOf(compared);
    scene.gravity = 0.0;
    scene.base.inclination = 0.0;
    scene.initial.clear();
    scene = stirred(scene, compared.disks);
    for (InitialDisk& disk : scene.initial)
      disk.vy -= 0.5;
    SceneDefinition turned = scene;
    turned.base.inclination = 0.7;
    const double cosine = std::cos(turned.base.inclination), sine = std::sin(turned.base.inclination);
    for (InitialDisk& disk : turned.initial)
      disk = {disk.species,
              cosine * disk.x - sine * disk.y,
              sine * disk.x + cosine * disk.y,
              cosine * disk.vx - sine * disk.vy,
              sine * disk.vx + cosine * disk.vy,
              disk.spin};
    expectSame(firstCollisions(scene, compared.collisions), firstCollisions(turned, compared.collisions), 1.0,
               scene.species[0].mass);
  }
}

TEST(Symmetry, AToothFurtherOnEverythingIsTheSame)
{
  for (const Compared& compared : COMPARED)
    for (const int teeth : {1, -3, 20})
    {
      if (compared.boundary != Boundary::PERIODIC)
        continue;
      SCOPED_TRACE(compared.name);
      const SceneDefinition scene = sceneOf(compared);
      SceneDefinition shifted = scene;
      for (InitialDisk& disk : shifted.initial)
      {
        disk.x += teeth * scene.base.tooth_width * std::cos(scene.base.inclination);
        disk.y += teeth * scene.base.tooth_width * std::sin(scene.base.inclination);
      }
      expectSame(firstCollisions(scene, compared.collisions), firstCollisions(shifted, compared.collisions),
                 1.0, scene.species[0].mass);
    }
}

TEST(Symmetry, TheOrderInWhichDisksAreListedDoesNotMatter)
{
  for (const Compared& compared : COMPARED)
  {
    SCOPED_TRACE(compared.name);
    const SceneDefinition scene = sceneOf(compared);
    SceneDefinition reordered = scene;
    std::reverse(reordered.initial.begin(), reordered.initial.end());
    auto other = firstCollisions(reordered, compared.collisions);
    for (CollisionRecord& record : other)
    {
      const auto last = static_cast<std::uint32_t>(compared.disks - 1);
      record.i = last - record.i;
      if (record.j && (record.j = last - *record.j) < record.i)
        std::swap(*record.j, record.i);
    }
    expectSame(firstCollisions(scene, compared.collisions), other, 1.0, scene.species[0].mass);
  }
}

/// A unit of time of 2^k, a unit of length of 4^k, so that gravity keeps its value, and a unit of mass.
struct Units
{
  double time, length, mass;

  Units(int k, double mass) : time(std::ldexp(1.0, k)), length(std::ldexp(1.0, 2 * k)), mass(mass) {}
};

SceneDefinition scaled(SceneDefinition scene, const Units& units)
{
  const double speed = units.length / units.time;
  scene.base.tooth_width *= units.length;
  scene.base.tooth_height *= units.length;
  scene.base.amplitude *= units.length;
  scene.base.horizontal_amplitude *= units.length;
  for (HarmonicDefinition& harmonic : scene.base.harmonics)
  {
    harmonic.amplitude *= units.length;
    harmonic.horizontal_amplitude *= units.length;
  }
  scene.base.wall_height *= units.length;
  for (OutlineCorner& corner : scene.base.profile)
    corner = {units.length * corner.s, units.length * corner.n};
  scene.base.frequency /= units.time;
  for (SpeciesDefinition& species : scene.species)
  {
    species.radius *= units.length;
    for (double& radius : species.size.radii)
      radius *= units.length;
    species.mass *= units.mass;
  }
  scene.contact.min_rebound_speed *= speed;
  scene.contact.contact_duration *= units.time;
  scene.contact.restitution_speed *= speed;
  scene.pour.drop_height *= units.length;
  scene.pour.speed *= speed;
  scene.feed.rate /= units.time;
  scene.feed.stretch = {units.length * scene.feed.stretch.from, units.length * scene.feed.stretch.to};
  scene.settle *= units.time;
  return scene;
}

/// All results of a run of 3 units of time with setpoints, in the given units.
std::vector<double> outcome(const SceneDefinition& scene, const Units& units)
{
  const double speed = units.length / units.time, impulse = units.mass * speed, energy = impulse * speed;
  Simulation simulation(scene);
  std::vector<double> out;
  simulation.observeCollisions(
      [&](const CollisionRecord& record)
      {
        out.insert(out.end(), {record.time / units.time, static_cast<double>(record.kind), 1.0 * record.i,
                               record.j ? 1.0 * *record.j : -1.0, record.normal_speed / speed,
                               record.normal_impulse / impulse, record.tangential_impulse / impulse});
      });
  simulation.setSlewRates(
      {0.1 / units.time, 10.0 / units.length, 0.002 * speed});  // Hz/s is 1/s^2: 1 / length
  simulation.advanceTo(1.0 * units.time);
  simulation.command(Quantity::INCLINATION, -0.05);
  simulation.command(Quantity::FREQUENCY, 27.0 / units.time);
  simulation.command(Quantity::AMPLITUDE, 0.0015 * units.length);
  simulation.advanceTo(3.0 * units.time);
  for (const DiskState& disk : simulation.disks())
    out.insert(out.end(),
               {1.0 * disk.id, disk.x / units.length, disk.y / units.length, disk.angle, disk.vx / speed,
                disk.vy / speed, disk.spin * units.time, disk.displacement / units.length});
  for (const SpeciesMeans& means : simulation.means())
    out.insert(out.end(), {*means.mean_vx / speed, *means.mean_vx_stderr / speed,
                           *means.kinetic_translational / energy, *means.kinetic_rotational / energy});
  out.insert(out.end(), {simulation.energy() / energy, simulation.baseImpulse().x() / impulse,
                         simulation.baseImpulse().y() / impulse, simulation.maxOverlap() / units.length});
  return out;
}

TEST(Symmetry, LengthsTimesAndMassesScaleToTheLastBit)
{
  // Products, quotients and roots by powers of four only change the exponent. The same holds for the whole
  // engine if it contains no constant with a unit (a tolerance of 1e-9 m, for example): all bits are
  // compared, over 10^4 collisions.
  for (const bool pairs : {false, true})
    for (const Boundary boundary : {Boundary::PERIODIC, Boundary::WALLED, Boundary::OPEN})
    {
      SceneDefinition scene = pairs ? test::mixture(50) : test::singleParticles(50);
      scene.boundary = boundary;
      if (boundary != Boundary::WALLED)
        scene = test::onAnOrbit(scene);
      scene.base.inclination = 0.02;
      scene.feed.rate = 10.0;
      scene.feed.stretch = {0.1, 0.3};
      if (boundary == Boundary::OPEN)
        scene.base.drive_frame = DriveFrame::BASE;
      if (boundary != Boundary::PERIODIC)
        scene = test::withSizes(scene);
      if (boundary != Boundary::OPEN)
        scene.base.profile = test::castle();
      scene.settle = 0.5;
      scene.contact.contact_duration = 1e-4;
      scene.contact.restitution_speed = 0.3;
      const std::vector<double> one = outcome(scene, Units(0, 1.0));
      for (const Units& units : {Units(1, 1.0), Units(-1, 0.25), Units(-10, 1.0 / 128), Units(8, 1024.0)})
      {
        const std::vector<double> other = outcome(scaled(scene, units), units);
        ASSERT_EQ(one.size(), other.size());
        for (std::size_t k = 0; k < one.size(); ++k)
          ASSERT_EQ(one[k], other[k]) << "value " << k << ", unit of time " << units.time;
      }
    }
}

/// The largest distance of a disk from its start [m] after a flight of `duration`, a reversal of all
/// velocities and spins, and another flight of `duration`. The base moves back as well: sin(k phi(T - t) +
/// phi_k) = sin(k phi'(t) + (1 - k) pi - phi_k), where phi' = pi - phi(T) + w t.
double errorThereAndBack(const SceneDefinition& scene, double duration)
{
  Simulation there(scene);
  there.advanceTo(duration);
  EXPECT_GT(there.collisions().total(), 0u);
  SceneDefinition reversed = scene;
  reversed.base.phase = PI - (scene.base.phase + 2.0 * PI * scene.base.frequency * duration);
  reversed.base.horizontal_phase = -scene.base.horizontal_phase;
  for (HarmonicDefinition& harmonic : reversed.base.harmonics)
  {
    harmonic.phase = (1 - harmonic.multiple) * PI - harmonic.phase;
    harmonic.horizontal_phase = (1 - harmonic.multiple) * PI - harmonic.horizontal_phase;
  }
  for (const DiskState& disk : there.disks())
    reversed.initial[disk.id] = {disk.species, disk.x, disk.y, -disk.vx, -disk.vy, -disk.spin};
  Simulation back(reversed);
  back.advanceTo(duration);
  double farthest = 0.0;
  for (const DiskState& disk : back.disks())
  {
    const InitialDisk& start = scene.initial[disk.id];
    const double dx = std::remainder(disk.x - start.x, scene.base.width());
    farthest = std::max(farthest, std::hypot(dx, disk.y - start.y));
  }
  return farthest;
}

/// The rounding error after a duration [m]. Over 101 starts the median was 3e-15 to 3e-14 m after 0.1 s and
/// 2e-8 to 6e-6 m after 0.6 s. It grows with an exponent of 31 to 38 / s (2 to 5 contacts per disk in 0.1 s,
/// each of which amplifies an error by distance over radius); 40 / s is used here.
double grownRounding(double duration)
{
  return 2e-15 * std::exp(40.0 * duration);
}

/// After 0.1 s the largest error of all starts was 7e-10 m. A start with a different collision on the way
/// back has an error of at least 1e-3 m.
constexpr double FARTHEST_AFTER_THE_FIRST = 1e-8;

TEST(Symmetry, LosslessDisksFindTheirWayBack)
{
  struct Driven
  {
    double amplitude;
    bool orbit;
  };
  for (const auto [amplitude, orbit] : {Driven{0.0, false}, Driven{0.002, false}, Driven{0.002, true}})
    for (const double rough : {0.0, 1.0})
    {
      SceneDefinition scene = orbit ? test::onAnOrbit(test::mixture(0)) : test::mixture(0);
      scene.base.amplitude = amplitude;
      scene.base.phase = 0.7;
      scene.contact.min_rebound_speed = 0.0;
      for (SpeciesDefinition& species : scene.species)
        species.contact = {1.0, rough * 1e9, rough};
      for (const double duration : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6})
      {
        std::vector<double> errors;
        for (unsigned seed = 1; seed <= 101; ++seed)
          errors.push_back(errorThereAndBack(stirred(scene, 20, seed), duration));
        std::sort(errors.begin(), errors.end());
        EXPECT_LT(errors[50], grownRounding(duration))
            << amplitude << " m, orbit " << orbit << ", rough " << rough << ", " << duration << " s";
        EXPECT_LT(duration > 0.1 ? 0.0 : errors.back(), FARTHEST_AFTER_THE_FIRST);
      }
    }
}

}  // namespace
}  // namespace ratchet_sieve
