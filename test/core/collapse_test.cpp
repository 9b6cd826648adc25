#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
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

TEST(Collapse, StopsTheRunInOrderAtTheSameBitsInWhateverStridesAtATimeThatCanBeAskedFor)
{
  for (const bool pair_collisions : {true, false})
    for (const int k : {0, 1, 7, 19})
    {
      const double start = 100.1 * k;
      SCOPED_TRACE("begun at " + std::to_string(start) + " s");
      Simulation stopped(collapsing(pair_collisions), start);
      EXPECT_THROW(stopped.advanceTo(start + 10.0), StallError);
      EXPECT_TRUE(stopped.stalled());
      const double time = stopped.time();
      EXPECT_GT(time, start + 0.05);
      EXPECT_LT(time, start + 10.0);
      EXPECT_THROW(stopped.advanceTo(start + 20.0), StallError);
      EXPECT_EQ(stopped.time(), time) << "it stays";
      Simulation in_strides(collapsing(pair_collisions), start);
      EXPECT_THROW(for (int j = 1; j <= 1000; ++j) in_strides.advanceTo(start + 0.01 * j), StallError);
      Simulation asked(collapsing(pair_collisions), start);
      EXPECT_THROW(asked.advanceTo(time), StallError);
      for (const Simulation* same : {&in_strides, &asked})
      {
        EXPECT_EQ(same->time(), time);
        EXPECT_EQ(test::stateHash(*same), test::stateHash(stopped));
        EXPECT_EQ(same->collapseText(), stopped.collapseText());
      }
      test::expectNoOverlap(stopped);
    }
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

TEST(Collapse, OfADiskThatNothingFreesStopsAnEnsembleInOrder)
{
  Simulation at_once(jammed());
  EXPECT_THROW(at_once.advanceTo(3.0), StallError);
  test::expectNoOverlap(at_once);
  EXPECT_EQ(at_once.activeDisks(), 3u);
  EXPECT_EQ(at_once.collapses().first_disk, 2u);
  EXPECT_NE(at_once.collapseText().find("disk 1 had"), std::string::npos) << at_once.collapseText();

  Simulation in_strides(jammed());
  EXPECT_THROW(for (int k = 1; k <= 3000; ++k) in_strides.advanceTo(0.001 * k), StallError);
  in_strides.auditOverlaps();
  EXPECT_EQ(in_strides.saveState(), at_once.saveState());
  EXPECT_EQ(in_strides.collapseText(), at_once.collapseText());
}

/// All disks come to rest within a few tenths of a second.
TEST(Collapse, OfManyDisksStopsAnEnsembleAtTheFirst)
{
  SceneDefinition scene = collapsing(false);
  scene.species[0].count = 1000;
  std::string state;
  for (const std::size_t threads : {1, 3})
  {
    Simulation simulation(scene);
    simulation.setThreads(threads);
    EXPECT_THROW(simulation.advanceTo(10.0), StallError);
    EXPECT_EQ(simulation.collapses().count, 1u);
    EXPECT_NEAR(simulation.time(), simulation.collapses().first_time, 1e-15);
    EXPECT_LT(simulation.events(), 100000u);
    if (state.empty())
      state = simulation.saveState();
    EXPECT_EQ(simulation.saveState(), state) << threads << " threads";
  }
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
  Simulation rebounds(resting);
  rebounds.advanceTo(1.0);
  EXPECT_FALSE(rebounds.stalled());

  SceneDefinition scene = wedged();
  scene.contact.min_rebound_speed = 1.0;
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

TEST(Collapse, OfAnEnsembleIsToldInTheOrderOfTimeInWhateverStrides)
{
  SceneDefinition scene = collapsing(false);
  scene.contact.collapse_events = 100000;
  std::vector<std::pair<double, std::uint32_t>> all;
  for (const double stride : {10.0, 0.001})
  {
    std::vector<std::pair<double, std::uint32_t>> told;
    Simulation simulation(scene);
    simulation.observeCollisions([&](const CollisionRecord& contact)
                                 { told.emplace_back(contact.time, contact.i); });
    EXPECT_THROW(for (int k = 1; k <= 10000; ++k) simulation.advanceTo(stride * k), StallError);
    EXPECT_GT(told.size(), 100000u);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end(),
                               [](const auto& a, const auto& b) { return a.first < b.first; }));
    if (all.empty())
      all = told;
    EXPECT_TRUE(told == all) << "strides of " << stride << " s";
  }
}

TEST(Collapse, IsNotSeenWhereARestingDiskHopsAtTheFloor)
{
  SceneDefinition scene = collapsing(true);
  scene.contact.min_rebound_speed = 0.01;
  Simulation simulation(scene);
  simulation.advanceTo(2.0);
  EXPECT_EQ(simulation.collapses().count, 0u);
}

}  // namespace
}  // namespace ratchet_sieve
