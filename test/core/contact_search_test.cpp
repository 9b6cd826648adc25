#include "search/contact_search.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "constants.h"
#include "draws.h"
#include "profiles.h"

namespace ratchet_sieve
{
namespace
{
constexpr double RESOLUTION = 1e-14;
constexpr double HORIZON = 0.4;

/// Straight and oblique, circular, or with arbitrary harmonics.
void drawOrbit(BaseDefinition& base)
{
  base.horizontal_amplitude = *rc::gen::element(0.0, 0.002, -0.005, 0.01);
  base.horizontal_phase = *rc::gen::element(0.0, 1.5707963267948966, 4.0);
  for (int count = *rc::gen::inRange(0, 3); count > 0; --count)
    base.harmonics.push_back({*rc::gen::inRange(2, 8), drawn(-0.001, 0.001), drawn(0.0, 6.28),
                              drawn(-0.001, 0.001), drawn(0.0, 6.28)});
}

/// One of several difficult shapes: plain, vertical faces, flat, needles, fine and coarse teeth, upside down.
BaseDefinition drawnBase()
{
  BaseDefinition base;
  base.teeth = 5;
  base.asymmetry = *rc::gen::element(0.0, 0.1, 0.3, 0.5, 0.9, 1.0);
  base.tooth_height = *rc::gen::element(0.0, 0.001, 0.006, 0.06);
  base.inclination = *rc::gen::element(0.0, 0.209, -0.1, 1.2, 2.5);
  base.amplitude = *rc::gen::element(0.0, 0.002, 0.01);
  base.phase = drawn(0.0, 6.28);
  if (*rc::gen::inRange(0, 3) == 0)
    base.profile = test::drawnProfile(0.02, std::max(0.001, base.tooth_height), 12);
  if (*rc::gen::arbitrary<bool>())
    drawOrbit(base);
  return base;
}

/// From lower than the teeth to higher than any flight.
double drawnWallHeight()
{
  return *rc::gen::element(0.001, 0.01, 0.03, 0.1, 10.0);
}

struct Thrown
{
  Disk disk;
  double radius;
};

/// A disk that starts anywhere free of the base, in any direction.
Thrown drawnDisk(const BaseMotion& motion, const BaseShape& shape)
{
  const double radius = *rc::gen::element(1e-5, 0.001, 0.004, 0.02, 0.3);
  const FrameOfBase base = motion.at(0.0);
  const double s = std::fmod(drawn(radius, 0.1 - radius * (radius < 0.05)), shape.width());
  double n = radius + drawn(0.0, 0.03);
  while (std::min(shape.heightAbove(s, n), shape.distanceToWalls(s, n)) < radius)
    n += 0.1 * radius;
  Thrown thrown;
  thrown.radius = radius;
  const Eigen::Vector2d place = base.positionOutOf({s, n});
  thrown.disk.position.x() = place.x();
  thrown.disk.position.y() = place.y();
  thrown.disk.velocity.x() = drawn(-2.0, 2.0);
  thrown.disk.velocity.y() = drawn(-2.0, 2.0);
  return thrown;
}

double gapAt(const ContactSearch& search, const BaseShape& shape, const Thrown& thrown, double time)
{
  const BasePoint point = search.seenFromBase(thrown.disk, time);
  return std::min(shape.heightAbove(point.s(), point.n()), shape.distanceToWalls(point.s(), point.n())) -
         thrown.radius;
}

/// Searches from event to event until a contact is certain, as the loops do.
BaseEvent searchOn(const ContactSearch& search, const Thrown& thrown)
{
  BaseEvent event{0.0, {}};
  for (int i = 0; i < 1000 && !event.feature && event.time < HORIZON; ++i)
    event = search.find(thrown.disk, thrown.radius, event.time, HORIZON);
  return event;
}

/// Brute force: at many times before the contact, no disk touches or leaves. At the contact, the rim touches
/// and approaches, or the centre reaches the machine's end.
void checkAgainstScan(const BaseMotion& motion, const BaseShape& shape, const Thrown& thrown)
{
  const ContactSearch search(shape, motion, GRAVITY, RESOLUTION);
  const BaseEvent event = searchOn(search, thrown);
  const double tolerance = 1e-12 * (1.0 + thrown.radius);
  const double end = std::min(event.time, HORIZON);
  for (int i = 0; i < 2000; ++i)
  {
    RC_ASSERT(gapAt(search, shape, thrown, end * i / 2000.0) > -tolerance);
    const double s = search.seenFromBase(thrown.disk, end * i / 2000.0).s();
    RC_ASSERT(shape.boundary() == Boundary::PERIODIC || (s > -tolerance && s < shape.width() + tolerance));
  }
  RC_CLASSIFY(!event.feature, "no contact");
  if (!event.feature)
    return;
  const BasePoint point = search.seenFromBase(thrown.disk, event.time);
  const Approach approach = shape.approach(event.feature, point, thrown.radius);
  RC_ASSERT(std::abs(approach.gap) < tolerance);
  RC_ASSERT(approach.rate < 0.0);
  const double gap = gapAt(search, shape, thrown, event.time);
  RC_ASSERT(gap > -tolerance);
  RC_ASSERT(gap < tolerance || event.feature.isEnd());
}

TEST(ContactSearch, FindsTheFirstContactOfRandomFlights)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const BaseDefinition base = drawnBase();
        const BaseShape shape(base, Boundary::PERIODIC);
        const BaseMotion motion(base, 10.0);
        checkAgainstScan(motion, shape, drawnDisk(motion, shape));
      }));
}

TEST(ContactSearch, FindsTheFirstContactOnABaseThatTurns)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const BaseDefinition base = drawnBase();
        const BaseShape shape(base, Boundary::PERIODIC);
        BaseMotion motion(base, 10.0);
        motion.setSlewRates({*rc::gen::element(0.01, 0.3, 2.0), 10.0, 0.002}, 0.0);
        motion.command(Quantity::INCLINATION, base.inclination + *rc::gen::element(-1.0, 1.0), 0.0);
        motion.command(Quantity::FREQUENCY, 60.0, 0.0);
        motion.command(Quantity::AMPLITUDE, *rc::gen::element(base.amplitude, base.amplitude + 0.002), 0.0);
        RC_PRE(*motion.nextChange() > HORIZON);
        checkAgainstScan(motion, shape, drawnDisk(motion, shape));
      }));
}

TEST(ContactSearch, FindsTheFirstContactBetweenWalls)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const BaseDefinition base = drawnBase();
        const BaseShape shape(base, Boundary::WALLED, drawnWallHeight());
        const BaseMotion motion(base, 10.0);
        const Thrown thrown = drawnDisk(motion, shape);
        RC_PRE(thrown.radius < 0.05);
        checkAgainstScan(motion, shape, thrown);
      }));
}

TEST(ContactSearch, FindsTheFirstContactBetweenWallsThatTurn)
{
  EXPECT_TRUE(rc::check(
      []
      {
        const BaseDefinition base = drawnBase();
        const BaseShape shape(base, Boundary::WALLED, drawnWallHeight());
        BaseMotion motion(base, 10.0);
        motion.setSlewRates({*rc::gen::element(0.01, 0.3, 2.0), 10.0, 0.002}, 0.0);
        motion.command(Quantity::INCLINATION, base.inclination + *rc::gen::element(-1.0, 1.0), 0.0);
        motion.command(Quantity::FREQUENCY, 60.0, 0.0);
        RC_PRE(*motion.nextChange() > HORIZON);
        const Thrown thrown = drawnDisk(motion, shape);
        RC_PRE(thrown.radius < 0.05);
        checkAgainstScan(motion, shape, thrown);
      }));
}

/// Throws a disk that passes an apex of a base at rest at the distance `miss`.
std::optional<BaseFeatureKind> passApex(double miss)
{
  BaseDefinition base;
  base.amplitude = 0.0;
  base.tooth_height = 0.02;
  const BaseShape shape(base, Boundary::PERIODIC);
  const BaseMotion motion(base, 10.0);
  const ContactSearch search(shape, motion, GRAVITY, RESOLUTION);
  // The top of its parabola is above the apex, so that its lowest point grazes the apex.
  const double flight = 0.002;
  Thrown thrown;
  thrown.radius = 0.001;
  thrown.disk.velocity.x() = 3.0;
  thrown.disk.velocity.y() = GRAVITY * flight;
  thrown.disk.position.x() = 0.106 - thrown.disk.velocity.x() * flight;
  thrown.disk.position.y() = 0.02 + thrown.radius + miss - 0.5 * GRAVITY * flight * flight;
  BaseEvent event{0.0, {}};
  while (!event.feature && event.time < 2.0 * flight)
    event = search.find(thrown.disk, thrown.radius, event.time, 2.0 * flight);
  return event.feature ? std::optional<BaseFeatureKind>(event.feature.kind()) : std::nullopt;
}

TEST(ContactSearch, TellsAGrazeFromAMiss)
{
  for (const double miss : {1e-6, 1e-9, 1e-12})
  {
    EXPECT_FALSE(passApex(miss)) << miss;
    ASSERT_TRUE(passApex(-miss)) << -miss;
    EXPECT_EQ(*passApex(-miss), BaseFeatureKind::CORNER);
  }
}

TEST(ContactSearch, ADiskBehindASlopeMeetsItWhenItComesInFront)
{
  // It starts to the right of an apex, behind the line of the left slope, flies over the apex to the left and
  // lands on that slope.
  BaseDefinition base;
  base.amplitude = 0.0;
  base.asymmetry = 0.5;
  base.tooth_height = 0.02;
  const BaseShape shape(base, Boundary::PERIODIC);
  const BaseMotion motion(base, 10.0);
  const ContactSearch search(shape, motion, GRAVITY, RESOLUTION);
  Thrown thrown;
  thrown.radius = 0.0005;
  thrown.disk.position.x() = 0.1125;
  thrown.disk.position.y() = 0.018;
  thrown.disk.velocity.x() = -0.06;
  thrown.disk.velocity.y() = 0.5;
  const BaseEvent event = searchOn(search, thrown);
  ASSERT_TRUE(event.feature);
  EXPECT_EQ(shape.kindOf(event.feature), CollisionKind::LEFT_SLOPE);
  EXPECT_EQ(event.feature.tooth(), 5);
}

TEST(ContactSearch, AboveTheBandItIsFreeUntilItComesDown)
{
  const BaseDefinition base;
  const BaseShape shape(base, Boundary::PERIODIC);
  const BaseMotion motion(base, 10.0);
  const ContactSearch search(shape, motion, GRAVITY, RESOLUTION);
  Disk disk;
  disk.position.x() = 0.1;
  disk.position.y() = 1.0;
  const double into_the_band = std::sqrt(2.0 * (1.0 - 0.006 - 0.002 - 0.001) / GRAVITY);
  const BaseEvent above = search.find(disk, 0.001, 0.0, 0.9 * into_the_band);
  EXPECT_FALSE(above.feature);
  EXPECT_GE(above.time, 0.9 * into_the_band);
  const BaseEvent down = search.find(disk, 0.001, above.time, 1.0);
  EXPECT_TRUE(down.feature);
  EXPECT_GT(down.time, into_the_band);
}

TEST(ContactSearch, ADiskThatLeavesAnOpenBaseIsSeenAtItsEnd)
{
  const BaseDefinition base;
  const BaseShape shape(base, Boundary::OPEN);
  const BaseMotion motion(base, 10.0);
  const ContactSearch search(shape, motion, GRAVITY, RESOLUTION);
  Disk disk;
  disk.position.x() = 0.399;
  disk.position.y() = 0.1;
  disk.velocity.x() = 0.5;
  const BaseEvent event = search.find(disk, 0.001, 0.0, 0.1);
  ASSERT_TRUE(event.feature);
  EXPECT_EQ(event.feature.kind(), BaseFeatureKind::RIGHT_END);
  EXPECT_NEAR(event.time, 0.002, 1e-14);
}

}  // namespace
}  // namespace ratchet_sieve
