#include "model/collision_law.h"

#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "runs.h"

namespace ratchet_sieve
{
namespace
{

/// A disk of 2 kg against the base: m_n = 2 kg, m_t = 2 / (1 + 1 / alpha) = 2/3 kg for alpha = 1/2.
Inertia disk(double mass, double alpha = 0.5)
{
  SpeciesDefinition species;
  species.inertia_factor = alpha;
  return {mass, leverOf(species)};
}

SpeciesDefinition speciesOf(double mass)
{
  SpeciesDefinition species;
  species.mass = mass;
  species.radius = 0.1;
  return species;
}

TEST(ContactMasses, BaseIsInfinite)
{
  const ContactMasses masses = contactMasses(disk(2.0));
  EXPECT_DOUBLE_EQ(masses.normal, 2.0);
  EXPECT_DOUBLE_EQ(masses.tangential, 2.0 / 3.0);
}

TEST(ContactMasses, PairOfDifferentMassesAndInertias)
{
  const Inertia other = disk(3.0, 0.4);
  const ContactMasses masses = contactMasses(disk(2.0), other);
  EXPECT_DOUBLE_EQ(masses.normal, 1.2);                          // 1 / (1/2 + 1/3)
  EXPECT_DOUBLE_EQ(masses.tangential, 1.0 / (1.5 + 7.0 / 6.0));  // 1/2 + 1/3 + 2/2 + 2.5/3
}

TEST(ContactMasses, InertiaCountsInTheTangentialOneOnly)
{
  // m / (1 + 1 / alpha): 2 / 3.5 for a sphere, 2 / 2 for a ring, 2 / 11 for a mass concentrated near the
  // centre.
  const double cases[][2] = {{0.4, 4.0 / 7.0}, {1.0, 1.0}, {0.1, 2.0 / 11.0}};
  for (const auto& [alpha, tangential] : cases)
  {
    EXPECT_DOUBLE_EQ(contactMasses(disk(2.0, alpha)).normal, 2.0);
    EXPECT_DOUBLE_EQ(contactMasses(disk(2.0, alpha)).tangential, tangential);
    const Inertia same = disk(2.0, alpha);
    EXPECT_DOUBLE_EQ(contactMasses(same, same).tangential, tangential / 2.0) << "two alike: half";
  }
}

struct LawCase
{
  const char* branch;
  ContactCoefficients coefficients;
  double v_n, v_t, v_min;
  double j_n, j_t;
};

/// Computed by hand for m_n = 2 kg, m_t = 2/3 kg.
const LawCase CASES[] = {
    {"smooth, elastic", {1.0, 0.0, 0.0}, -3.0, 5.0, 0.0, 12.0, 0.0},
    {"smooth, inelastic", {0.5, 0.0, 0.0}, -3.0, 5.0, 0.0, 9.0, 0.0},
    {"sliding: mu J_n = 0.9 < 3.33", {0.5, 0.1, 0.0}, -3.0, 5.0, 0.0, 9.0, -0.9},
    {"sliding the other way", {0.5, 0.1, 0.0}, -3.0, -5.0, 0.0, 9.0, 0.9},
    {"sticking: 2/3 * 0.3 = 0.2 < 0.9", {0.5, 0.1, 0.0}, -3.0, 0.3, 0.0, 9.0, -0.2},
    {"sticking with beta: 1.4 * 0.2", {0.5, 0.1, 0.4}, -3.0, 0.3, 0.0, 9.0, -0.28},
    {"perfectly rough", {1.0, 1000.0, 1.0}, -3.0, 3.0, 0.0, 12.0, -4.0},
    {"border of sliding and sticking: 2/3 * 1.35 = 0.9", {0.5, 0.1, 0.0}, -3.0, 1.35, 0.0, 9.0, -0.9},
    {"just within the border sticks", {0.5, 0.1, 0.0}, -3.0, 1.344, 0.0, 9.0, -0.896},
    {"just beyond it slides", {0.5, 0.1, 0.0}, -3.0, 1.356, 0.0, 9.0, -0.9},
    {"beta moves the border: 2 * 2/3 * 0.675", {0.5, 0.1, 1.0}, -3.0, 0.675, 0.0, 9.0, -0.9},
    {"beta below 0: 0.5 * 0.2", {0.5, 0.1, -0.5}, -3.0, 0.3, 0.0, 9.0, -0.1},
    {"beta = 0 stops the surface: 2/3 * 3", {0.5, 1000.0, 0.0}, -3.0, 3.0, 0.0, 9.0, -2.0},
    {"a surface at rest gets nothing", {0.5, 0.1, 1.0}, -3.0, 0.0, 0.0, 9.0, 0.0},
    {"beta = -1 is smooth whatever mu", {0.5, 10.0, -1.0}, -3.0, 5.0, 0.0, 9.0, 0.0},
    {"rebound floor: 0.5 * 0.04 < 0.05", {0.5, 0.0, 0.0}, -0.04, 0.0, 0.05, 0.18, 0.0},
    {"elastic below the floor gains: 0.05 + 0.04", {1.0, 0.0, 0.0}, -0.04, 0.0, 0.05, 0.18, 0.0},
    {"at the floor: 0.5 * 0.1 = 0.05", {0.5, 0.0, 0.0}, -0.1, 0.0, 0.05, 0.3, 0.0},
    {"the floor lets friction stick: 0.018 > 2/3 * 0.006", {0.5, 0.1, 0.0}, -0.04, 0.006, 0.05, 0.18, -0.004},
    {"above the floor", {0.5, 0.0, 0.0}, -0.2, 0.0, 0.05, 0.6, 0.0},
    {"friction on the floored impulse", {0.5, 0.1, 0.0}, -0.04, 5.0, 0.05, 0.18, -0.018},
    {"e = 0 with a floor", {0.0, 0.0, 0.0}, -1.0, 0.0, 0.05, 2.1, 0.0},
    {"e = 0 without", {0.0, 0.0, 0.0}, -1.0, 0.0, 0.0, 2.0, 0.0},
    {"lossless", LOSSLESS, -0.3, 7.0, 0.0, 1.2, 0.0},
};

/// For m_n = 1.2 kg, m_t = 0.375 kg: disks of 2 kg, alpha = 1/2, and 3 kg, alpha = 0.4; see above.
const LawCase PAIR_CASES[] = {
    {"elastic: 2 * 3 * 1.2", {1.0, 0.0, 0.0}, -3.0, 5.0, 0.0, 7.2, 0.0},
    {"sliding: 0.1 * 5.4 < 0.375 * 5", {0.5, 0.1, 0.0}, -3.0, 5.0, 0.0, 5.4, -0.54},
    {"sticking: 1.4 * 0.375 * 0.8 < 0.54", {0.5, 0.1, 0.4}, -3.0, 0.8, 0.0, 5.4, -0.42},
    {"perfectly rough: 2 * 0.375 * 4", {1.0, 1000.0, 1.0}, -3.0, -4.0, 0.0, 7.2, 3.0},
    {"rebound floor: 1.2 * (0.04 + 0.05)", {0.5, 0.0, 0.0}, -0.04, 0.0, 0.05, 0.108, 0.0},
};

template <std::size_t N>
void expectByHand(const LawCase (&cases)[N], const ContactMasses& masses)
{
  for (const LawCase& c : cases)
  {
    const Impulse impulse = collide({c.v_min, 0.0, 0.0}, c.coefficients, masses, c.v_n, c.v_t);
    // Rounding of values of about 10.
    EXPECT_NEAR(impulse.normal, c.j_n, 1e-14) << c.branch;
    EXPECT_NEAR(impulse.tangential, c.j_t, 1e-14) << c.branch;
  }
}

TEST(Collide, EveryBranchAgainstNumbersWorkedOutByHand)
{
  expectByHand(CASES, {2.0, 2.0 / 3.0});
  expectByHand(PAIR_CASES, {1.2, 0.375});
}

struct SlowCase
{
  const char* what;
  double restitution, v_0, q, v_n, v_min;
  double j_n;
};

/// Computed by hand for m_n = 2 kg: J_n = 2 (1 + e(v)) |v_n|.
const SlowCase SLOW_CASES[] = {
    {"(1/16)^(3/4) = 1/8: e = 1 - 0.5 / 8", 0.5, 1.0, 0.75, -0.0625, 0.0, 1.9375 * 0.125},
    {"the same share of another v_0", 0.5, 4.0, 0.75, -0.25, 0.0, 1.9375 * 0.5},
    {"(1/256)^(3/4) = 1/64", 0.5, 1.0, 0.75, -0.00390625, 0.0, (2.0 - 0.5 / 64.0) / 128.0},
    {"at v_0", 0.5, 1.0, 0.75, -1.0, 0.0, 3.0},
    {"above it", 0.5, 1.0, 0.75, -4.0, 0.0, 12.0},
    {"q = 1: e = 1 - 0.5 * 0.5", 0.5, 1.0, 1.0, -0.5, 0.0, 1.75},
    {"q = 1/2: e = 1 - 0.5 * 0.5", 0.5, 1.0, 0.5, -0.25, 0.0, 0.875},
    {"q = 2: e = 1 - 0.5 / 4", 0.5, 1.0, 2.0, -0.5, 0.0, 1.875},
    {"q = 0: e at all speeds", 0.5, 1.0, 0.0, -0.25, 0.0, 0.75},
    {"e = 0: 7/8 of a sixteenth", 0.0, 1.0, 0.75, -0.0625, 0.0, 1.875 * 0.125},
    {"e = 1 loses nothing", 1.0, 1.0, 0.75, -0.0625, 0.0, 0.25},
    {"a floor below what comes of it does nothing", 0.5, 1.0, 0.75, -0.0625, 0.05, 1.9375 * 0.125},
    {"a floor above it is the speed after", 0.5, 1.0, 0.75, -0.0625, 0.1, 2.0 * 0.1625},
};

TEST(Collide, ASlowContactLosesLess)
{
  for (const SlowCase& c : SLOW_CASES)
  {
    const CollisionLaw law{c.v_min, c.v_0, c.q};
    const Impulse impulse = collide(law, {c.restitution, 0.1, 0.0}, {2.0, 2.0 / 3.0}, c.v_n, 5.0);
    EXPECT_NEAR(impulse.normal, c.j_n, 1e-14) << c.what;
    EXPECT_NEAR(impulse.tangential, -0.1 * c.j_n, 1e-14) << c.what;
  }
}

/// At most 18 digits, each with a root of two roundings and a product, ten whole powers, and the series.
TEST(Power, AgreesWithTheLibraryInLongDouble)
{
  constexpr long double TOLERANCE = 80 * 0x1p-53L;
  for (const double exponent :
       {0.0, 1e-7, 0.1, 0.2, 1.0 / 3.0, 0.5, 0.6, 0.75, 1.0 - 0x1p-53, 1.0, 1.25, 2.7})
    for (int i = 0; i < 2000; ++i)
    {
      const double x = std::exp(-0.12 * i);
      const long double expected = std::pow(static_cast<long double>(x), static_cast<long double>(exponent));
      ASSERT_LT(std::abs(power(x, exponent) - expected), TOLERANCE * expected) << x << " " << exponent;
    }
  for (const double exponent : {0.2, 0.75, 3.0})
    EXPECT_EQ(power(0.0, exponent), 0.0);
  EXPECT_EQ(power(0.0, 0.0), 1.0);
  EXPECT_EQ(power(1.0, 0.3), 1.0);
  EXPECT_EQ(power(0.0625, 0.75), 0.125);
}

TEST(ContactBetween, PairsOwnCoefficientsOrElseTheMean)
{
  SceneDefinition scene;
  scene.species = {speciesOf(1.0), speciesOf(2.0)};
  scene.species[0].contact = {0.6, 0.1, 0.4};
  scene.species[1].contact = {0.8, 0.3, 0.0};
  EXPECT_DOUBLE_EQ(contactBetween(scene, 0, 1).restitution, 0.7);
  EXPECT_DOUBLE_EQ(contactBetween(scene, 1, 0).friction, 0.2);
  EXPECT_DOUBLE_EQ(contactBetween(scene, 0, 0).tangential_restitution, 0.4);
  scene.pairs = {{1, 0, {0.9, 0.0, -1.0}}};
  EXPECT_EQ(contactBetween(scene, 0, 1).restitution, 0.9);
  EXPECT_EQ(contactBetween(scene, 1, 0).tangential_restitution, -1.0);
  EXPECT_EQ(contactBetween(scene, 1, 1).restitution, 0.8);
}

/// Two species over a base at rest without gravity: A of 2 g, 1 mm, a disk; B of 3 g, 2 mm, a sphere.
SceneDefinition weightless()
{
  SceneDefinition scene;
  scene.gravity = 0.0;
  scene.base.amplitude = 0.0;
  scene.contact.min_rebound_speed = 0.0;
  scene.species.resize(2);
  scene.species[0].radius = 0.001;
  scene.species[0].mass = 0.002;
  scene.species[0].contact = {0.6, 0.1, 0.4};
  scene.species[1].radius = 0.002;
  scene.species[1].mass = 0.003;
  scene.species[1].inertia_factor = 0.4;
  scene.species[1].contact = {0.8, 0.3, 0.0};
  return scene;
}

/// A double resolves positions of 0.1 m so that normals of disks of 1 mm have errors of 1e-14. Velocities of
/// 1 m/s and spins of 100 /s have relative errors no larger than that.
void expectVelocity(const DiskState& disk, double vx, double vy, double spin)
{
  EXPECT_NEAR(disk.vx, vx, 1e-13);
  EXPECT_NEAR(disk.vy, vy, 1e-13);
  EXPECT_NEAR(disk.spin, spin, 1e-10);
}

TEST(CollisionByHand, ADiskSlidesOnAFlatBase)
{
  // n = (0, 1), t = (-1, 0). Its surface moves with 0.3 + 0.001 * 100 = 0.4 to the right: v_t = -0.4.
  // J_n = 1.6 * 0.002 = 0.0032, mu J_n = 0.00032 < 1.4 * 0.002 / 3 * 0.4 = 0.000373: J_t = 0.00032.
  // vx = 0.3 - 0.16, vy = -1 + 1.6, spin = 100 - 0.001 * 0.00032 / (0.5 * 0.002 * 1e-6).
  SceneDefinition scene = weightless();
  scene.base.tooth_height = 0.0;
  scene.initial = {{0, 0.1, 0.002, 0.3, -1.0, 100.0}};
  Simulation simulation(scene);
  simulation.advanceTo(0.002);
  expectVelocity(simulation.disks()[0], 0.14, 0.6, -220.0);
}

TEST(CollisionByHand, ASphereSticksToAFlatBase)
{
  // v_t = -0.03, (1 + 0) * 0.003 / 3.5 * 0.03 = 2.5714e-5 < 0.3 * 1.8 * 0.003: it rolls with 5/7 of its
  // speed.
  SceneDefinition scene = weightless();
  scene.base.tooth_height = 0.0;
  scene.initial = {{1, 0.1, 0.003, 0.03, -1.0, 0.0}};
  Simulation simulation(scene);
  simulation.advanceTo(0.002);
  expectVelocity(simulation.disks()[0], 0.03 * 5.0 / 7.0, 0.8, -0.03 * 5.0 / 7.0 / 0.002);
}

TEST(CollisionByHand, ADiskSlidesOnALeftSlope)
{
  // Teeth of 8 mm and 12 mm by 6 mm: the left slope's n = (-0.6, 0.8), t = (-0.8, -0.6). v = (0, -1): v_n =
  // -0.8, v_t = 0.6. J_n = 1.6 * 0.8 * 0.002, and mu J_n = 0.000256 < 1.4 * 0.002 / 3 * 0.6 = 0.00056: J_t =
  // -0.000256. v = (0, -1) + 1.28 n - 0.128 t, spin = 0.001 * 0.000256 / 1e-9.
  SceneDefinition scene = weightless();
  scene.base.asymmetry = 0.4;
  scene.initial = {{0, 0.1 + 0.0034, 0.006, 0.0, -1.0, 0.0}};
  Simulation simulation(scene);
  simulation.advanceTo(0.003);
  EXPECT_EQ(simulation.collisions().left_slope, 1u);
  expectVelocity(simulation.disks()[0], -0.6656, 0.1008, 256.0);
}

/// A falls with 1 m/s onto B, which is at rest. They touch with n = (0.6, 0.8) from B to A, t = (-0.8, 0.6):
/// v_n = -0.8, v_t = -0.6 - (0.001 * 100 + 0.002 * 50) = -0.8. m_n = 1.2 g, m_t = 0.375 g.
std::vector<DiskState> afterThePairMet(SceneDefinition scene, bool a_first)
{
  scene.initial = {{0, 0.1 + 0.0018, 0.05 + 0.0024 + 0.002, 0.0, -1.0, 100.0},
                   {1, 0.1, 0.05, 0.0, 0.0, 50.0}};
  if (!a_first)
    std::swap(scene.initial[0], scene.initial[1]);
  Simulation simulation(scene);
  simulation.advanceTo(0.004);
  EXPECT_EQ(simulation.collisions().total(), 1u);
  auto disks = simulation.disks();
  if (!a_first)
    std::swap(disks[0], disks[1]);
  return disks;
}

TEST(CollisionByHand, APairWithTheMeanOfItsSpeciesSlides)
{
  // e = 0.7, mu = 0.2, beta = 0.2: J_n = 1.7 * 0.8 * 0.0012 = 0.001632, mu J_n = 0.0003264
  // < 1.2 * 0.000375 * 0.8 = 0.00036. A: (0, -1) + 0.816 n + 0.1632 t; B: -0.544 n - 0.1088 t.
  // Spins: 100 - 0.001 J_t / 1e-9 and 50 - 0.002 J_t / 4.8e-9.
  for (const bool a_first : {true, false})
  {
    const auto disks = afterThePairMet(weightless(), a_first);
    expectVelocity(disks[0], 0.35904, -0.24928, -226.4);
    expectVelocity(disks[1], -0.23936, -0.50048, -86.0);
  }
}

TEST(CollisionByHand, APairWithCoefficientsOfItsOwnSticks)
{
  // e = 0.5, beta = 1: J_n = 1.5 * 0.8 * 0.0012 = 0.00144, J_t = 2 * 0.000375 * 0.8 = 0.0006 < mu J_n.
  // A: (0, -1) + 0.72 n + 0.3 t; B: -0.48 n - 0.2 t. Spins: 100 - 600 and 50 - 250.
  SceneDefinition scene = weightless();
  for (const bool a_first : {true, false})
  {
    scene.pairs = {{a_first ? 1u : 0u, a_first ? 0u : 1u, {0.5, 1.0, 1.0}}};
    const auto disks = afterThePairMet(scene, a_first);
    expectVelocity(disks[0], 0.192, -0.244, -500.0);
    expectVelocity(disks[1], -0.128, -0.504, -200.0);
  }
}

TEST(CollisionByHand, BetweenWallsTheContactDurationDecides)
{
  // Half a gap of 18 mm to the first wall at 1 m/s, then 18 mm at 0.6 m/s: 0.03 s. With t_c below that, every
  // contact reduces the speed by 0.4. With t_c above it, only the first does, because each contact restarts
  // t_c. Walls are smooth: the spin is unchanged.
  for (const double duration : {0.0, 0.029, 0.031})
  {
    SceneDefinition scene = weightless();
    scene.boundary = Boundary::WALLED;
    scene.base.teeth = 1;
    scene.contact.contact_duration = duration;
    scene.initial = {{0, 0.01, 0.05, 1.0, 0.0, 100.0}};
    Simulation simulation(scene);
    const auto records = test::collisionsUntil(simulation, 0.2);
    ASSERT_GE(records.size(), 3u);
    const double e = duration > 0.03 ? 1.0 : 0.6;
    EXPECT_NEAR(records[0].normal_impulse, 1.6 * 0.002, 1e-15);
    EXPECT_NEAR(records[1].time, 0.009 + 0.03, 1e-15);
    EXPECT_NEAR(records[1].normal_impulse, (1.0 + e) * 0.6 * 0.002, 1e-15);
    EXPECT_NEAR(records[2].time, 0.039 + 0.03 / e, 1e-15);
    EXPECT_NEAR(records[2].normal_speed, 0.6 * e, 1e-13);
    EXPECT_NEAR(records[2].normal_impulse, (1.0 + e) * 0.6 * e * 0.002, 1e-15);
    EXPECT_EQ(simulation.disks()[0].spin, 100.0);
  }
}

/// Checks that the first contact of a scene, at 1/16 m/s and v_0 = 1 m/s, has J_n = (1 + e(v)) m_n / 16.
void expectSlowContact(SceneDefinition scene, CollisionKind kind, double mass, double restitution)
{
  scene.contact.restitution_speed = 1.0;
  const auto records = test::collisionsUntil(scene, 0.15);
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(records[0].kind, kind);
  EXPECT_NEAR(records[0].normal_speed, 0.0625, 1e-13);
  EXPECT_NEAR(records[0].normal_impulse, (1.0 + restitution) * 0.0625 * mass, 1e-15);
}

TEST(CollisionByHand, SlowContactsLoseLessWhateverIsMet)
{
  // (1/16)^(3/4) = 1/8: e = 1 - 0.4 / 8 with the base and with a wall, 1 - 0.3 / 8 between A and B.
  SceneDefinition scene = weightless();
  scene.base.asymmetry = 0.4;
  for (const bool pairs : {true, false})
  {
    scene.contact.pair_collisions = pairs;
    scene.initial = {{0, 0.1 + 0.0034, 0.006, 0.0, -0.078125, 0.0}};
    expectSlowContact(scene, CollisionKind::LEFT_SLOPE, 0.002, 0.95);
    scene.initial = {{0, 0.1 + 0.008, 0.008, 0.0, -0.0625, 0.0}};
    expectSlowContact(scene, CollisionKind::APEX, 0.002, 0.95);
  }
  SceneDefinition walled = scene;
  walled.boundary = Boundary::WALLED;
  walled.base.teeth = 1;
  walled.initial = {{0, 0.01, 0.05, 0.0625, 0.0, 0.0}};
  expectSlowContact(walled, CollisionKind::WALL, 0.002, 0.95);
  scene.contact.pair_collisions = true;
  scene.initial = {{0, 0.1, 0.054, 0.0, -0.0625, 0.0}, {1, 0.1, 0.05, 0.0, 0.0, 0.0}};
  expectSlowContact(scene, CollisionKind::DISK_DISK, 0.0012, 0.9625);
}

TEST(CollisionByHand, TheFloorDoesNotApplyWithinTheContactDuration)
{
  // A leaves the base at the minimum rebound speed, 0.1 m/s, after 1 ms. 8 ms later it reaches B, which moves
  // ahead of it at 0.05 m/s: J_n = 2 * 0.05 * 0.0012 within t_c, also with a speed-dependent restitution;
  // otherwise (0.05 + 0.1) * 0.0012.
  for (const double v_0 : {0.0, 1.0})
    for (const bool within : {true, false})
    {
      SceneDefinition scene = weightless();
      scene.base.tooth_height = 0.0;
      scene.contact.min_rebound_speed = 0.1;
      scene.contact.contact_duration = within ? 0.0081 : 0.0079;
      scene.contact.restitution_speed = v_0;
      scene.initial = {{0, 0.1, 0.0011, 0.0, -0.1, 0.0}, {1, 0.1, 0.00435, 0.0, 0.05, 0.0}};
      const auto records = test::collisionsUntil(scene, 0.01);
      ASSERT_EQ(records.size(), 2u);
      EXPECT_EQ(records[1].kind, CollisionKind::DISK_DISK);
      EXPECT_NEAR(records[1].time, 0.009, 1e-12);
      EXPECT_NEAR(records[1].normal_impulse, (within ? 0.1 : 0.15) * 0.0012, 1e-15);
    }
}

/// A hits the flat base at 0.6 times its speed, and later B; times are counted from the first contact.
struct SecondContact
{
  double a_height, a_speed;  // [m], [m/s] downwards
  double b_height, b_speed;
  double closing;  // of the two [m/s]
  double later;    // [s]
};

TEST(CollisionByHand, APairLosesNothingIfEitherPartnerHasJustMet)
{
  // First A goes up with 0.6 m/s, and B hangs 0.5 mm higher: met after 5/6 ms. Then A hardly rebounds, with 6
  // mm/s after 1 ms, while B comes from afar with 1 m/s: they are 49 - 1 - 3 mm apart then, 44.7316 ms
  // at 1.006 m/s. With e = 0.7 or 1: J_n = (1 + e) v_n * 0.0012.
  const SecondContact cases[] = {{0.0012, 1.0, 0.0045, 0.0, 0.6, 0.000833333},
                                 {0.00101, 0.01, 0.050, 1.0, 1.006, 0.0447316}};
  for (const SecondContact& c : cases)
    for (const bool a_first : {true, false})
      for (const double share : {0.99, 1.01})
      {
        SceneDefinition scene = weightless();
        scene.base.tooth_height = 0.0;
        scene.contact.contact_duration = share * c.later;
        scene.initial = {{0, 0.1, c.a_height, 0.0, -c.a_speed, 0.0},
                         {1, 0.1, c.b_height, 0.0, -c.b_speed, 1.0}};
        if (!a_first)
          std::swap(scene.initial[0], scene.initial[1]);
        // Onlookers make the cells small, so that it is B that finds A when it comes from afar, not A that
        // finds B when it rebounds.
        for (int k = 0; k < 200; ++k)
          scene.initial.push_back({0, 0.0075 * (k % 50) + 0.01, 0.10 + 0.01 * (k / 50), 0.0, 0.0, 0.0});
        const auto records = test::collisionsUntil(scene, 0.05);
        ASSERT_GE(records.size(), 2u);
        EXPECT_EQ(records[1].kind, CollisionKind::DISK_DISK);
        EXPECT_NEAR(records[1].time - records[0].time, c.later, 1e-6 * c.later);  // as it is printed above
        const double e = share < 1.0 ? 0.7 : 1.0;
        EXPECT_NEAR(records[1].normal_impulse, (1.0 + e) * c.closing * 0.0012, 1e-15);
        EXPECT_EQ(records[1].tangential_impulse == 0.0, share > 1.0) << "smooth as well";
      }
}

}  // namespace
}  // namespace ratchet_sieve
