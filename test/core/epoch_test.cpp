#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "constants.h"
#include "events/engine.h"
#include "ratchet_sieve/core/resolution.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

constexpr double LARGEST_OVERLAP = 1e-9;  // of the radius

/// Setpoints are reached within a fraction of a period, but not faster than the drive itself moves.
constexpr SlewRates SOON{1e3, 1e9, 10.0};

/// Very small disks: a fast drive needs a finer time resolution than the scene, which has no drive, was set
/// up for.
SceneDefinition tinyDisksAtRest(bool pairs)
{
  SceneDefinition scene = pairs ? test::mixture(10) : test::singleParticles(10);
  scene.base.teeth = 1;
  scene.base.amplitude = 0.0;
  scene.contact.pair_collisions = pairs;
  for (SpeciesDefinition& species : scene.species)
    species.radius = 2e-7;
  return scene;
}

TEST(Epoch, AFrequencyWithoutAnAmplitudeCostsNothing)
{
  for (const bool pairs : {true, false})
  {
    SceneDefinition scene = pairs ? test::mixture(20) : test::singleParticles(20);
    scene.base.amplitude = 0.0;
    Simulation slow(scene);
    scene.base.frequency = 1e6;
    Simulation fast(scene);
    slow.advanceTo(1.0);
    fast.advanceTo(1.0);
    EXPECT_EQ(fast.events(), slow.events());
    EXPECT_EQ(test::stateHash(fast), test::stateHash(slow));
  }
}

/// Nothing falls and almost nothing moves, so epochs last seconds, until the base hits the disks.
TEST(Epoch, GetsFinerWhereADriveIsCommandedThatNeedsIt)
{
  for (const bool pairs : {true, false})
  {
    SCOPED_TRACE(pairs ? "pairs" : "single disks");
    SceneDefinition scene = tinyDisksAtRest(pairs);
    scene.base.tooth_height = 0.0;
    scene.gravity = 0.0;
    constexpr std::size_t DISKS = 10;
    for (std::size_t k = 0; k < DISKS; ++k)
      scene.initial.push_back({0, 0.0021 + 0.0015 * static_cast<double>(k),
                               0.0011 + 0.00007 * static_cast<double>(k), 0.0, -1e-4, 0.0});
    Simulation simulation(scene);
    simulation.setSlewRates(SOON);
    simulation.advanceTo(3.1);
    simulation.command(Quantity::FREQUENCY, 1000.0);
    simulation.command(Quantity::AMPLITUDE, 0.002);
    simulation.advanceTo(3.11);
    EXPECT_GE(simulation.collisions().total(), DISKS);
    EXPECT_LT(simulation.maxOverlap(), LARGEST_OVERLAP * scene.species[0].radius);
  }
}

TEST(Epoch, ThePhaseGoesOnWhereItGetsFiner)
{
  Simulation simulation(tinyDisksAtRest(true));
  simulation.setSlewRates(SOON);
  simulation.advanceTo(0.4);
  simulation.command(Quantity::FREQUENCY, 1000.0);
  simulation.advanceTo(0.5);
  const double before = simulation.base().phase;
  simulation.command(Quantity::AMPLITUDE, 0.002);
  EXPECT_NEAR(simulation.base().phase, before, 1e-9);
  EXPECT_EQ(simulation.time(), 0.5);
  simulation.advanceTo(0.5 + 20.25e-3);
  EXPECT_NEAR(std::remainder(simulation.base().phase - before - 0.5 * PI, 2.0 * PI), 0.0, 1e-8);
  EXPECT_NEAR(simulation.base().displacement, 0.002 * std::sin(simulation.base().phase), 1e-12);
}

/// The largest distance between the surfaces of a contact, of either sign [radii of the smallest disk].
class LargestGap final : public Observer
{
public:
  unsigned subscriptions() const override { return CONTACTS; }
  void collided(const ContactOutcome& outcome) override
  {
    largest = std::max(largest, std::abs(outcome.overlap) / RADIUS);
    ++contacts;
  }

  static constexpr double RADIUS = 0.001;  // m
  double largest = 0.0;
  std::size_t contacts = 0;
};

TEST(Epoch, ContactsAfterAMillionSecondsAreAsExactAsAtTheStart)
{
  for (const double start : {0.0, 1e6, 1e6 + 1.0 / 3.0})
  {
    const SceneDefinition scene = test::mixture(40);
    ASSERT_EQ(scene.species[0].radius, LargestGap::RADIUS);
    Engine engine(scene, start, {});
    const LargestGap* gaps = engine.state().log().add(std::make_unique<LargestGap>());
    engine.advanceTo(start + 5.0);
    EXPECT_GT(gaps->contacts, 10000u);
    EXPECT_LT(gaps->largest, 2e-12) << start;
  }
}

TEST(Epoch, IsShorterWhereItsFallsWouldBeTooFastForTheSmallestDisk)
{
  SceneDefinition scene = test::mixture(1);
  EXPECT_EQ(SystemState(scene).epoch().length, epochLength(timeScale(scene)));
  scene.species[1].radius = 1e-6;
  EXPECT_EQ(SystemState(scene).epoch().length, longestFall(scene.gravity, 1e-6));
}

/// Each way is less than the position's resolution, as of contacts in a collapse.
TEST(Disk, MovesByManyWaysThatAreLostToRounding)
{
  Disk disk;
  disk.position = {1.0, -1.0};
  for (int k = 0; k < 1000; ++k)
    disk.redirect(Two{3e-17, 1e-17}, Two{}, 0.25);
  EXPECT_NEAR(disk.position.x() - 1.0, 3e-14, 3e-16);
  EXPECT_NEAR(disk.position.y() + 1.0, 1e-14, 3e-16);
  EXPECT_EQ(disk.eventCount(), 1000u);
}

TEST(StartTime, IsWhereTimeCountsFrom)
{
  // Rounding errors of contact times grow as in any run: about tenfold per collision of a disk.
  constexpr double SOON = 0.03;  // s
  constexpr double NEAR = 1e-9;
  SceneDefinition scene = test::mixture(20);
  scene.feed.rate = 20.0;
  Simulation at_zero(scene);
  at_zero.advanceTo(SOON);
  for (const double start : {0.3, 7.77, 12345.678})
  {
    Simulation later(scene, start);
    EXPECT_EQ(later.time(), start);
    EXPECT_EQ(later.startTime(), start);
    later.advanceTo(start + SOON);
    const std::vector<DiskState> expected = at_zero.disks();
    const std::vector<DiskState> disks = later.disks();
    ASSERT_EQ(disks.size(), expected.size());
    for (std::size_t k = 0; k < disks.size(); ++k)
    {
      EXPECT_NEAR(disks[k].x, expected[k].x, NEAR);
      EXPECT_NEAR(disks[k].y, expected[k].y, NEAR);
    }
    // time() is exactly the requested time, in any epoch.
    for (int k = 1; k < 60; ++k)
    {
      later.advanceTo(start + k / 7.0);
      ASSERT_EQ(later.time(), start + k / 7.0);
    }
    EXPECT_EQ(later.auditOverlaps(), 0u);
  }
}

}  // namespace
}  // namespace ratchet_sieve
