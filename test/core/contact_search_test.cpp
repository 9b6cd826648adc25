#include "search/contact_search.h"

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
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED})
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

}  // namespace
}  // namespace ratchet_sieve
