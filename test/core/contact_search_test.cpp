#include "search/contact_search.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "constants.h"
#include "flights.h"

namespace ratchet_sieve
{
namespace
{
constexpr double RESOLUTION = 1e-14;

/// From lower than the teeth to higher than any flight.
double drawnWallHeight()
{
  return *rc::gen::element(0.001, 0.01, 0.03, 0.1, 10.0);
}

/// @param turns whether the base is on its way to other setpoints
void checkDrawnFlight(Boundary boundary, bool turns)
{
  const BaseDefinition base = test::drawnBase(12);
  const double walls = boundary == Boundary::WALLED ? drawnWallHeight() : 0.0;
  const BaseShape shape(base, boundary, walls);
  BaseMotion motion(base, 10.0);
  if (turns)
  {
    motion.setSlewRates({*rc::gen::element(0.01, 0.3, 2.0), 10.0, 0.002}, 0.0);
    motion.command(Quantity::INCLINATION, base.inclination + *rc::gen::element(-1.0, 1.0), 0.0);
    motion.command(Quantity::FREQUENCY, 60.0, 0.0);
    motion.command(Quantity::AMPLITUDE, *rc::gen::element(base.amplitude, base.amplitude + 0.002), 0.0);
    RC_PRE(*motion.nextChange() > test::HORIZON);
  }
  const double radius = *rc::gen::element(1e-5, 0.001, 0.004, 0.02, 0.3);
  RC_PRE(boundary == Boundary::PERIODIC || radius < 0.05);
  const Disk disk = test::drawnFlight(motion, shape, radius, 2.0);
  const ContactSearch search(shape, motion, GRAVITY, RESOLUTION);
  const BaseEvent event = test::searchOn(search, disk);
  if (event.feature)
    RC_ASSERT(shape.approach(event.feature, search.seenFromBase(disk, event.time), radius).rate < 0.0);
  test::checkAgainstScan(search, shape, disk, event, 1e-12 * (1.0 + radius));
}

TEST(ContactSearch, FindsTheFirstContactOfRandomFlights)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::WALLED})
    for (const bool turns : {false, true})
      EXPECT_TRUE(rc::check([=] { checkDrawnFlight(boundary, turns); }));
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
  Disk disk;
  disk.radius = 0.001;
  disk.velocity.x() = 3.0;
  disk.velocity.y() = GRAVITY * flight;
  disk.position.x() = 0.106 - disk.velocity.x() * flight;
  disk.position.y() = 0.02 + disk.radius + miss - 0.5 * GRAVITY * flight * flight;
  const BaseEvent event = test::searchOn(search, disk);
  return event.feature && event.time < 2.0 * flight ? std::optional<BaseFeatureKind>(event.feature.kind())
                                                    : std::nullopt;
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
  Disk disk;
  disk.radius = 0.0005;
  disk.position.x() = 0.1125;
  disk.position.y() = 0.018;
  disk.velocity.x() = -0.06;
  disk.velocity.y() = 0.5;
  const BaseEvent event = test::searchOn(search, disk);
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
  disk.radius = 0.001;
  disk.position.x() = 0.1;
  disk.position.y() = 1.0;
  const double into_the_band = std::sqrt(2.0 * (1.0 - 0.006 - 0.002 - 0.001) / GRAVITY);
  const BaseEvent above = search.find(disk, 0.0, 0.9 * into_the_band);
  EXPECT_FALSE(above.feature);
  EXPECT_GE(above.time, 0.9 * into_the_band);
  const BaseEvent down = search.find(disk, above.time, 1.0);
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
  disk.radius = 0.001;
  disk.position.x() = 0.399;
  disk.position.y() = 0.1;
  disk.velocity.x() = 0.5;
  const BaseEvent event = search.find(disk, 0.0, 0.1);
  ASSERT_TRUE(event.feature);
  EXPECT_EQ(event.feature.kind(), BaseFeatureKind::RIGHT_END);
  EXPECT_NEAR(event.time, 0.002, 1e-14);
}

}  // namespace
}  // namespace ratchet_sieve
