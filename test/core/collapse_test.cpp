#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"
#include "state/collapse_watch.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

/// Disks that fall on a base at rest without a minimum rebound speed: the times between a disk's rebounds are
/// a geometric series that converges to zero.
SceneDefinition collapsing(bool pair_collisions)
{
  SceneDefinition scene = test::mixture(30);
  scene.base.teeth = 5;
  scene.base.amplitude = 0.0;
  for (SpeciesDefinition& species : scene.species)
    species.contact.restitution = 0.1;
  scene.contact.pair_collisions = pair_collisions;
  scene.contact.min_rebound_speed = 0.0;
  scene.contact.collapse_events = 10000;
  return scene;
}

/// Disk 1 fits exactly between two walls: once pushed to one side, it has contacts without time between them.
/// Disk 2 comes to rest earlier, disk 0 later.
SceneDefinition jammed()
{
  SceneDefinition scene = collapsing(false);
  scene.boundary = Boundary::WALLED;
  scene.base.teeth = 1;
  scene.base.tooth_width = 0.004;
  scene.base.tooth_height = 0.0005;
  scene.species[0].radius = 0.0005;
  scene.species[1].radius = 0.002;
  scene.initial = {{0, 0.001, 0.2}, {1, 0.002, 0.04}, {0, 0.003, 0.01}};
  scene.contact.on_collapse = CollapseAction::REBOUND;
  scene.contact.collapse_events = 1000;
  return scene;
}

/// All disks come to rest within a few tenths of a second.
SceneDefinition manyAtRest()
{
  SceneDefinition scene = collapsing(false);
  scene.species[0].count = 1000;
  return scene;
}

/// A run that ends in a collapse within 20 s, and the contacts that it told of.
struct Collapsed
{
  /// @param stride [s]
  Collapsed(const SceneDefinition& scene, double start, double stride, std::size_t threads = 1)
      : simulation(scene, start)
  {
    simulation.setThreads(threads);
    simulation.observeCollisions([this](const CollisionRecord& record) { told.push_back(record); });
    EXPECT_THROW(for (int k = 1; stride * k <= 20.0; ++k) simulation.advanceTo(start + stride * k),
                 StallError);
    EXPECT_TRUE(simulation.stalled());
    test::expectNoOverlap(simulation);
  }

  Simulation simulation;
  std::vector<CollisionRecord> told;
};

void expectTheSame(const Collapsed& one, const Collapsed& other)
{
  EXPECT_EQ(one.simulation.time(), other.simulation.time());
  EXPECT_TRUE(one.simulation.saveState() == other.simulation.saveState());
  EXPECT_EQ(one.simulation.collapseText(), other.simulation.collapseText());
  EXPECT_TRUE(
      std::equal(one.told.begin(), one.told.end(), other.told.begin(), other.told.end(), test::areSame));
}

/// At a time that can be asked for, and it stays there.
TEST(Collapse, StopsARunInOrderAtTheSameBitsHoweverItIsAdvanced)
{
  for (const SceneDefinition& scene : {collapsing(true), collapsing(false), jammed(), manyAtRest()})
    for (const double start : {0.0, 1901.9})
    {
      SCOPED_TRACE("begun at " + std::to_string(start) + " s");
      Collapsed stopped(scene, start, 20.0);
      const double time = stopped.simulation.time();
      EXPECT_GT(time, start + 0.05);
      EXPECT_TRUE(std::is_sorted(stopped.told.begin(), stopped.told.end(),
                                 [](const auto& a, const auto& b) { return a.time < b.time; }));
      expectTheSame(Collapsed(scene, start, 0.001), stopped);
      expectTheSame(Collapsed(scene, start, 20.0, 3), stopped);
      Simulation asked(scene, start);
      EXPECT_THROW(asked.advanceTo(time), StallError);
      EXPECT_EQ(test::stateHash(asked), test::stateHash(stopped.simulation));
      EXPECT_THROW(stopped.simulation.advanceTo(start + 30.0), StallError);
      EXPECT_EQ(stopped.simulation.time(), time);
    }
}

TEST(Collapse, OfAnEnsembleIsThatOfTheFirstDiskThatNothingFrees)
{
  const Collapsed wedged(jammed(), 0.0, 20.0);
  EXPECT_EQ(wedged.simulation.activeDisks(), 3u);
  EXPECT_EQ(wedged.simulation.collapses().first_disk, 2u);
  EXPECT_NE(wedged.simulation.collapseText().find("disk 1 had"), std::string::npos);
  const Collapsed many(manyAtRest(), 0.0, 20.0);
  EXPECT_EQ(many.simulation.collapses().count, 1u);
  EXPECT_NEAR(many.simulation.time(), many.simulation.collapses().first_time, 1e-15);
  EXPECT_LT(many.simulation.events(), 100000u);
}

TEST(Collapse, SaysWhichDiskAndWhenInNumbers)
{
  SceneDefinition scene = collapsing(true);
  scene.species[0].count = 1;
  scene.species[1].count = 0;
  scene.base.tooth_height = 0.0;
  scene.base.frequency = 0.0;
  Simulation simulation(scene);
  EXPECT_EQ(simulation.collapseText(), "");
  EXPECT_THROW(simulation.advanceTo(10.0), StallError);
  // It falls for sqrt(2 H / g); the hops take (1 + e) / (1 - e) times that, including the fall.
  const double height = scene.pour.drop_height + scene.base.amplitude;
  const double end = std::sqrt(2.0 * height / 9.81) * (1.0 + 2.0 * 0.1 / 0.9);
  EXPECT_NEAR(simulation.collapses().first_time, end, 1e-9);
  EXPECT_EQ(simulation.collapses().first_disk, 0u);
  EXPECT_NE(simulation.collapseText().find("disk 0 had more than 10000 events within 0.04515"),
            std::string::npos)
      << simulation.collapseText();
}

/// Disks without rebound slide along steep slopes, through many collapses. Their positions are tens of metres
/// from the origin, with a resolution coarser than the displacement between two contacts. If the position
/// were rounded at each contact, the overlap would grow with each.
TEST(Collapse, OfSlidingDisksDoesNotPressThemIntoTheBase)
{
  SceneDefinition scene = test::mixture(15);
  scene.base.teeth = 3000;
  scene.base.tooth_height = 0.04;
  scene.base.asymmetry = 0.5;
  scene.base.inclination = 0.5;
  scene.base.amplitude = 0.02;
  scene.gravity = 1.6;
  for (SpeciesDefinition& species : scene.species)
    species.contact = {0.0, 0.0, 0.0};
  scene.contact.min_rebound_speed = 0.0;
  scene.contact.on_collapse = CollapseAction::REBOUND;
  scene.contact.collapse_events = 20000;
  Simulation simulation(scene);
  simulation.advanceTo(0.3);
  EXPECT_GT(simulation.collapses().count, 10u);
  test::expectNoOverlap(simulation);
}

/// Threads advance the disks of an ensemble in any order; the report of the first collapse must not depend on
/// it.
TEST(Collapse, OfSeveralDisksAtOneTimeTheSmallestIdIsTheFirst)
{
  ContactDefinition contact;
  contact.on_collapse = CollapseAction::REBOUND;
  contact.collapse_events = 10;
  const DiskIds ids;
  SlotArray<DiskRecord> disks(3);
  CollapseWatch watch(contact, 1.0, 1.0, disks, ids);
  for (int k = 0; !watch.stuck(0); ++k)
    for (const std::uint32_t disk : {1, 2, 0})
    {
      watch.count(disk, 0.5);
      EXPECT_EQ(watch.counts().count > 0, k >= contact.collapse_events);
    }
  EXPECT_EQ(watch.counts().first_disk, 0u);
  EXPECT_NE(watch.text().find("disk 0 had"), std::string::npos) << watch.text();
}

/// A disk in a slot of its own width has contacts without time between them.
SceneDefinition wedged()
{
  SceneDefinition scene = test::singleParticles(1);
  scene.base.teeth = 1;
  scene.base.profile = {{0.0, 0.0},     {0.004, 0.0},    {0.004, 0.006}, {0.010, 0.006},
                        {0.016, 0.003}, {0.016, -0.002}, {0.020, 0.0}};
  scene.boundary = Boundary::WALLED;
  scene.species[0].radius = 0.002;
  scene.initial = {{0, 0.002, 0.012}};
  return scene;
}

/// A disk lies across a slot that is narrower than itself by a rounding, on a base that moves. Were its fast
/// contacts lossless, too, it would leave the base at 15 m/s.
TEST(Collapse, TakesNoMoreEnergyFromTheBaseThanOfAFallFromATooth)
{
  SceneDefinition scene = test::singleParticles(1);
  scene.base.teeth = 1;
  const double end = 0.012 - 1e-12;
  scene.base.profile = {{0.0, 0.0}, {0.008, 0.0}, {0.008, -0.01}, {end, -0.01}, {end, 0.0}, {0.02, 0.0}};
  scene.boundary = Boundary::WALLED;
  scene.species[0].radius = 0.002;
  scene.initial = {{0, 0.01 - 5e-13, 0.004}};
  scene.contact.on_collapse = CollapseAction::REBOUND;
  scene.contact.collapse_events = 1000;
  Simulation simulation(scene);
  EXPECT_THROW(simulation.advanceTo(5.0), StallError);
  const DiskState disk = simulation.disks()[0];
  const double drive = scene.base.amplitude * angularFrequency(scene.base.frequency);
  EXPECT_LT(std::hypot(disk.vx, disk.vy), std::sqrt(scene.gravity * scene.base.toothWidth()) + 2.0 * drive);
}

/// What a report suggests is tried.
TEST(Collapse, SuggestsOnlyWhatHelps)
{
  SceneDefinition resting = collapsing(true);
  resting.contact.min_rebound_speed = 0.0;
  Simulation rests(resting);
  EXPECT_THROW(rests.advanceTo(10.0), StallError);
  const std::string text = rests.collapseText();
  EXPECT_NE(
      text.find("min_rebound_speed of 0.0142 m/s or more may avoid it, or contact.on_collapse: rebound, if"),
      std::string::npos)
      << text;
  resting.contact.min_rebound_speed = 0.0142;
  Simulation hops(resting);
  hops.advanceTo(1.0);
  EXPECT_FALSE(hops.stalled());
  resting.contact.min_rebound_speed = 0.0;
  resting.contact.on_collapse = CollapseAction::REBOUND;
  resting.contact.collapse_events = 1000;
  Simulation rebounds(resting);
  rebounds.advanceTo(2.0 * rests.time());
  EXPECT_FALSE(rebounds.stalled());

  SceneDefinition scene = wedged();
  scene.contact.min_rebound_speed = 1.0;
  scene.contact.collapse_events = 10000;
  Simulation stops(scene);
  EXPECT_THROW(stops.advanceTo(1.0), StallError);
  EXPECT_NE(stops.collapseText().find("; contact.on_collapse: rebound may free it, if it has room"),
            std::string::npos)
      << stops.collapseText();
  scene.contact.on_collapse = CollapseAction::REBOUND;
  Simulation stuck(scene);
  EXPECT_THROW(stuck.advanceTo(1.0), StallError);
  EXPECT_NE(stuck.collapseText().find("its slow contacts were lossless: it has no room"), std::string::npos)
      << stuck.collapseText();
}

TEST(Collapse, TellsOfContactsBeforeTheyAreTooMany)
{
  struct Enough
  {
  };
  Simulation simulation(wedged());
  simulation.observeCollisions([](const CollisionRecord&) { throw Enough(); });
  EXPECT_THROW(simulation.advanceTo(1.0), Enough);
  EXPECT_LT(simulation.events(), 100000u);

  std::size_t told = 0;
  Simulation to_the_end(wedged());
  to_the_end.observeCollisions([&](const CollisionRecord&) { ++told; });
  EXPECT_THROW(to_the_end.advanceTo(1.0), StallError);
  EXPECT_GT(told, 900000u);
  test::expectNoOverlap(to_the_end);
}

}  // namespace
}  // namespace ratchet_sieve
