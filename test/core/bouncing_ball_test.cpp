#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "constants.h"
#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"

/// One inelastic ball on a flat plate that moves as A sin(w t): the map from hit to hit is known in closed
/// form (Luck & Mehta, Phys. Rev. E 48, 3988 (1993), doi:10.1103/PhysRevE.48.3988; Holmes, J. Sound Vib. 84,
/// 173 (1982), doi:10.1016/S0022-460X(82)80002-3, in the limit of high bounces). Gamma = A w^2 / g.
///
/// Period one: flights of T = 2 pi / w between equal heights begin with v = g T / 2 and end with -v. So the
/// plate's speed at the hit is u = v (1 - e) / (1 + e), which gives the phase of the hit: cos p = pi (1 - e)
/// / (Gamma (1 + e)).
///
/// Its stability: with Y = A sin(w t), a hit at t and a take-off at v lead to t' and v' by
///   Y(t') = Y(t) + v (t' - t) - g (t' - t)^2 / 2,    v' = -e (v - g (t' - t)) + (1 + e) Y'(t').
/// Linearised about the orbit, where v = g T / 2 and u + v = g T / (1 + e):
///   dt' = dt + (1 + e) / g dv,    dv' = -(1 + e) a dt + (e^2 - (1 + e)^2 a / g) dv,    a = A w^2 sin p,
/// with determinant e^2 and trace 1 + e^2 - (1 + e)^2 a / g. It is unstable for a < 0, and for a trace below
/// -(1 + e^2): period doubling at a / g = 2 (1 + e^2) / (1 + e)^2. This is exact.
namespace ratchet_sieve
{
namespace
{

constexpr double FREQUENCY = 50.0;
constexpr double OMEGA = 2.0 * PI * FREQUENCY;
constexpr double PERIOD = 1.0 / FREQUENCY;
constexpr double RADIUS = 0.001;

/// The smallest Gamma with a period-one orbit.
double periodOneFrom(double restitution)
{
  return PI * (1.0 - restitution) / (1.0 + restitution);
}

/// The largest Gamma with a stable period-one orbit.
double periodOneTo(double restitution)
{
  const double e = restitution;
  return std::hypot(periodOneFrom(e), 2.0 * (1.0 + e * e) / ((1.0 + e) * (1.0 + e)));
}

SceneDefinition ballOnPlate(double restitution, double gamma, double min_rebound_speed = 0.0)
{
  SceneDefinition scene = test::singleParticles(0);
  scene.gravity = GRAVITY;
  scene.base.tooth_height = 0.0;
  scene.base.amplitude = gamma * GRAVITY / (OMEGA * OMEGA);
  scene.base.frequency = FREQUENCY;
  scene.species[0].radius = RADIUS;
  scene.species[0].contact = {restitution, 0.0, 0.0};
  scene.contact.min_rebound_speed = min_rebound_speed;
  return scene;
}

/// Starts near the period-one orbit, so that the run converges to it: 1e-6 m above the plate, with the speed
/// of the orbit, at the phase of its hits minus 0.05.
double startNearPeriodOne(SceneDefinition& scene, double gamma, double restitution)
{
  const double phase = std::acos(periodOneFrom(restitution) / gamma);
  scene.base.phase = phase - 0.05;
  scene.initial = {{0, 0.1, RADIUS + scene.base.amplitude * std::sin(scene.base.phase) + 1e-6, 0.0,
                    GRAVITY * PERIOD / 2.0, 0.0}};
  return phase;
}

TEST(BouncingBall, HitsAPlateAtRestInAGeometricSeries)
{
  // Dropped from H it hits at t = sqrt(2 H / g), and then after flights of 2 t e, 2 t e^2, ...: textbook
  // result.
  SceneDefinition scene = ballOnPlate(0.6, 0.0);
  scene.initial = {{0, 0.1, RADIUS + 0.05, 0.0, 0.0, 0.0}};
  const double fall = std::sqrt(2.0 * 0.05 / GRAVITY);
  const double end = fall * (1.0 + 2.0 * 0.6 / 0.4);
  const auto records = test::collisionsUntil(scene, end - 1e-7);
  ASSERT_GT(records.size(), 25u);
  double time = fall, flight = 2.0 * fall;
  for (std::size_t k = 0; k < 25; ++k)
  {
    // 4e-5 of 0.4 s are left before the last of these. A double resolves the way of a flight since the
    // epoch's zero, up to 1 m, to 1e-16 m. The impact speed v is at least 5e-6 m/s: that is 1e-16 m / v =
    // 2e-11 s.
    EXPECT_NEAR(records[k].time, time, 5e-11) << k;
    EXPECT_NEAR(records[k].normal_speed, GRAVITY * fall * std::pow(0.6, k), GRAVITY * 5e-11) << k;
    flight *= 0.6;
    time += flight;
  }
}

TEST(BouncingBall, LosesLessTheSlowerItHits)
{
  // Each hit at v takes off with e(v) v and returns with the same speed after 2 e(v) v / g.
  for (const double exponent : {0.75, 0.2, 1.0, 2.0})
  {
    SceneDefinition scene = ballOnPlate(0.6, 0.0);
    scene.contact.restitution_speed = 0.8;
    scene.contact.restitution_exponent = exponent;
    scene.initial = {{0, 0.1, RADIUS + 0.05, 0.0, 0.0, 0.0}};
    double speed = std::sqrt(2.0 * 0.05 * GRAVITY);
    double time = speed / GRAVITY;
    // Before the accumulation point of its hits, which is at 0.489 s for q = 1/5.
    const auto records = test::collisionsUntil(scene, exponent < 0.5 ? 0.45 : 0.9);
    ASSERT_GT(records.size(), 6u);
    for (const CollisionRecord& record : records)
    {
      EXPECT_NEAR(record.time, time, 1e-12) << exponent;
      EXPECT_NEAR(record.normal_speed, speed, 1e-11) << exponent;
      speed *= speed < 0.8 ? 1.0 - 0.4 * std::pow(speed / 0.8, exponent) : 0.6;
      time += 2.0 * speed / GRAVITY;
    }
  }
}

/// With a = (1 - e) / v_0^q the speed after n hits decreases as (q a n)^(-1/q). The sum of the following
/// flights is finite for q < 1: 1.2 s here. For q = 2 there are about (20 s / 0.37 s)^2 hits in 20 s.
TEST(BouncingBall, ComesToRestWithASmallExponentAndNotWithALargeOne)
{
  for (const double exponent : {0.75, 2.0})
  {
    SceneDefinition scene = ballOnPlate(0.6, 0.0);
    scene.contact.restitution_speed = 0.8;
    scene.contact.restitution_exponent = exponent;
    scene.contact.collapse_events = 1000;
    scene.initial = {{0, 0.1, RADIUS + 0.01, 0.0, 0.0, 0.0}};
    Simulation simulation(scene);
    if (exponent < 1.0)
      EXPECT_THROW(simulation.advanceTo(20.0), StallError);
    else
      EXPECT_NO_THROW(simulation.advanceTo(20.0));
  }
}

TEST(BouncingBall, FindsThePhaseOfItsPeriodOneOrbit)
{
  for (const double e : {0.3, 0.6, 0.85})
    for (const double share : {0.2, 0.5, 0.8})
    {
      const double gamma = periodOneFrom(e) + share * (periodOneTo(e) - periodOneFrom(e));
      SceneDefinition scene = ballOnPlate(e, gamma);
      const double phase = startNearPeriodOne(scene, gamma, e);
      const auto records = test::collisionsUntil(scene, 30.0);
      ASSERT_GT(records.size(), 1400u);
      for (std::size_t k = records.size() - 100; k < records.size(); ++k)
      {
        // Only rounding keeps it off the orbit: times of 30 s are resolved to 4e-15 s, phases to 1e-12.
        EXPECT_NEAR(records[k].time - records[k - 1].time, PERIOD, 1e-12) << e << " " << gamma;
        EXPECT_NEAR(std::remainder(OMEGA * records[k].time + scene.base.phase - phase, 2.0 * PI), 0.0, 1e-10);
        EXPECT_NEAR(records[k].normal_speed, GRAVITY * PERIOD / (1.0 + e), 1e-11);
      }
    }
}

/// The difference of the last two flights after 200 s (10^4 hits).
double alternation(double restitution, double gamma)
{
  SceneDefinition scene = ballOnPlate(restitution, gamma);
  startNearPeriodOne(scene, gamma, restitution);
  const auto records = test::collisionsUntil(scene, 200.0);
  const std::size_t n = records.size();
  if (n < 10000 - 1)
    ADD_FAILURE() << "it hit " << n << " times in 10^4 periods";
  const double last = records[n - 1].time - records[n - 2].time;
  const double last_but_one = records[n - 2].time - records[n - 3].time;
  // Times of 200 s are resolved to 3e-14 s.
  EXPECT_NEAR(last + last_but_one, 2.0 * PERIOD, 1e-12) << "locked to two periods, if not to one";
  return std::abs(last - last_but_one);
}

TEST(BouncingBall, DoublesItsPeriodAtTheLimit)
{
  for (const double e : {0.3, 0.6, 0.85})
  {
    const double limit = periodOneTo(e);
    // 0.2 % below the limit, the multiplier of the slower mode is -0.97 (e = 0.85) or closer to 0: after 10^4
    // hits, only rounding is left of the initial deviation.
    for (const double share : {0.97, 0.99, 0.998})
      EXPECT_LT(alternation(e, share * limit), 1e-12) << e << " at " << share;
    // Above the limit, the two flights differ in proportion to the square root of the distance (a pitchfork
    // bifurcation). That gives the limit again, to within 0.1 %, because the square root is only the leading
    // term.
    const double near = std::pow(alternation(e, 1.002 * limit), 2);
    const double far = std::pow(alternation(e, 1.010 * limit), 2);
    EXPECT_GT(near, std::pow(0.01 * PERIOD, 2)) << e;
    EXPECT_NEAR(1.002 - 0.008 * near / (far - near), 1.0, 1e-3) << e;
  }
}

constexpr double FLOOR = 1e-4;  // [m/s]

/// With a minimum rebound speed v, a resting ball makes flights that begin with v and end with about v.
/// During a flight the relative acceleration G = g - A w^2 sin(w t) changes by G' t, t = 2 v / G, and the
/// flight ends with v (1 + 2/3 G' v / G^2); |G'| <= Gamma g w, G >= g (1 - Gamma).
double largestRestingSpeed(double gamma)
{
  return FLOOR * (1.0 + 2.0 / 3.0 * gamma * OMEGA * FLOOR / (GRAVITY * (1.0 - gamma) * (1.0 - gamma)));
}

/// Checks that the ball is at rest from `from` on: each later hit has the minimum rebound speed, and the
/// number of hits is right.
void expectRest(const std::vector<CollisionRecord>& records, double gamma, double from, double until)
{
  std::size_t count = 0;
  for (const CollisionRecord& record : records)
    if (record.time >= from)
    {
      ++count;
      ASSERT_NEAR(record.normal_speed, FLOOR, largestRestingSpeed(gamma) - FLOOR) << "at " << record.time;
    }
  // Hits a second: the mean of G / (2 v) is g / (2 v).
  EXPECT_NEAR(count / (until - from) / (GRAVITY / (2.0 * FLOOR)), 1.0, 0.01);
}

TEST(BouncingBall, ComesToRestBelowGammaOneWhereThereIsNoPeriodOne)
{
  ASSERT_LT(0.7, periodOneFrom(0.6));
  for (const double height : {0.0, 0.0003, 0.01})
  {
    SceneDefinition scene = ballOnPlate(0.6, 0.7, FLOOR);
    scene.initial = {{0, 0.1, RADIUS + height, 0.0, 0.0, 0.0}};
    expectRest(test::collisionsUntil(scene, 2.0), 0.7, 1.0, 2.0);
  }
}

TEST(BouncingBall, RestsOrBouncesWhereItCanDoEither)
{
  // Between pi (1 - e) / (1 + e) = 0.785 and 1 the final state depends on the start.
  const double gamma = 0.85;
  ASSERT_GT(gamma, periodOneFrom(0.6));
  SceneDefinition scene = ballOnPlate(0.6, gamma, FLOOR);
  scene.initial = {{0, 0.1, RADIUS, 0.0, 0.0, 0.0}};
  expectRest(test::collisionsUntil(scene, 2.0), gamma, 1.0, 2.0);
  startNearPeriodOne(scene, gamma, 0.6);
  const auto records = test::collisionsUntil(scene, 20.0);
  // The minimum rebound speed is far below the take-off speed and has no effect.
  EXPECT_NEAR(records.back().normal_speed, GRAVITY * PERIOD / 1.6, 1e-11);
}

/// Relative landing speed of a ball that rests until the plate falls away from it: it takes off at sin p = 1
/// / Gamma, with the plate's speed (Mehta & Luck, Phys. Rev. Lett. 65, 393 (1990),
/// doi:10.1103/PhysRevLett.65.393).
double landingSpeedFromRest(double gamma)
{
  const double amplitude = gamma * GRAVITY / (OMEGA * OMEGA);
  const double phase = std::asin(1.0 / gamma);
  const double speed = amplitude * OMEGA * std::cos(phase);
  const auto gap = [&](double t)
  { return amplitude * (std::sin(phase) - std::sin(phase + OMEGA * t)) + speed * t - 0.5 * GRAVITY * t * t; };
  double flying = 0.05 * PERIOD, landed = PERIOD;
  for (int k = 0; k < 60; ++k)
    (gap(0.5 * (flying + landed)) > 0.0 ? flying : landed) = 0.5 * (flying + landed);
  return amplitude * OMEGA * std::cos(phase + OMEGA * landed) - speed + GRAVITY * landed;
}

TEST(BouncingBall, TakesOffAboveGammaOneWhereThePlateFallsAwayFromIt)
{
  // With e = 0.2 the ball is at rest again long before the next take-off: one landing per period, and each
  // following hit is five times slower.
  const double gamma = 1.2;
  const double landing = landingSpeedFromRest(gamma);
  const double floor = 1e-5;
  SceneDefinition scene = ballOnPlate(0.2, gamma, floor);
  scene.initial = {{0, 0.1, RADIUS, 0.0, 0.0, 0.0}};
  // Because of its hops, its take-off speed differs from the plate's speed by up to the minimum rebound
  // speed. Until it lands, less than a period later, that difference grows at most by 1 + (landing
  // acceleration) T / (landing speed).
  const double tolerance = floor * (1.0 + GRAVITY * (1.0 + gamma) * PERIOD / landing);
  std::size_t landings = 0;
  for (const CollisionRecord& record : test::collisionsUntil(scene, 52 * PERIOD))
    if (record.time > 2 * PERIOD &&
        record.normal_speed > 0.5 * landing)  // the ball starts at rest in the world
    {
      ++landings;
      EXPECT_NEAR(record.normal_speed, landing, tolerance) << "at " << record.time;
    }
  EXPECT_EQ(landings, 50u);
}

}  // namespace
}  // namespace ratchet_sieve
