// Scenes with sizes so wide that their cells are nested.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "profiles.h"
#include "ratchet_sieve/core/simulation.h"
#include "reference_loop.h"
#include "scenes.h"
#include "search/size_levels.h"
#include "state/placement.h"

namespace ratchet_sieve
{
namespace
{

/// With so few disks that the slow reference keeps up: `small` of Fig. 3's, and others so many times as
/// large.
SceneDefinition scarce(int small, const std::vector<double>& ratios, Boundary boundary)
{
  SceneDefinition scene;
  scene.base.teeth = 3;
  scene.boundary = boundary;
  scene.species = {test::disksOfSize(1.0, small)};
  for (const double ratio : ratios)
    scene.species.push_back(test::disksOfSize(ratio, 1));
  return scene;
}

std::size_t levelsOf(const SceneDefinition& scene)
{
  const Simulation simulation(scene);
  std::vector<double> radii;
  for (const DiskState& disk : simulation.disks())
    radii.push_back(scene.species[disk.species].radius);
  return cheapestLevels(radii, 2.0 * *std::max_element(radii.begin(), radii.end())).count();
}

/// @param rate of turning to 0.3 rad; 0: the base stays
void expectSameContacts(SceneDefinition scene, double end, double rate, std::size_t least)
{
  ASSERT_GT(levelsOf(scene), 1u);
  for (const DiskState& disk : Simulation(scene).disks())
    scene.initial.push_back({disk.species, disk.x, disk.y, 0.3 - 0.01 * disk.id, -0.2, 0.0});
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;

  std::vector<CollisionRecord> fast;
  Simulation simulation(scene);
  simulation.observeCollisions([&](const CollisionRecord& record) { fast.push_back(record); });
  if (rate > 0.0)
  {
    simulation.setSlewRates({rate, 10.0, 0.002});
    simulation.command(Quantity::INCLINATION, 0.3);
  }
  simulation.advanceTo(end);

  std::vector<CollisionRecord> slow;
  test::Bench bench(scene);
  bench.state.observers().observeCollisions([&](const CollisionRecord& record) { slow.push_back(record); });
  placeInitialDisks(bench.state, 0.0);
  test::ReferenceLoop reference(bench, 1);
  if (rate > 0.0)
    test::turn(bench.state, rate, 0.3, 0.0);
  reference.advanceTo(end);

  ASSERT_GE(std::min(fast.size(), slow.size()), least);
  const auto disks = [](const CollisionRecord& r)
  { return std::make_pair(std::min(r.i, r.j.value_or(r.i)), std::max(r.i, r.j.value_or(r.i))); };
  for (std::size_t k = 0; k < least; ++k)
  {
    ASSERT_NEAR(fast[k].time, slow[k].time, 1e-7) << "collision " << k;
    ASSERT_EQ(fast[k].kind, slow[k].kind) << "collision " << k;
    ASSERT_EQ(disks(fast[k]), disks(slow[k])) << "collision " << k;
  }
}

TEST(WideSizes, MeetTheSameContactsAsTheReference)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED})
    for (const double ratio : {4.0, 6.0, 10.0})
    {
      SCOPED_TRACE(std::to_string(static_cast<int>(boundary)) + ", " + std::to_string(ratio));
      expectSameContacts(scarce(60, {ratio}, boundary), 0.08, 0.0, 200);
    }
}

TEST(WideSizes, MeetTheSameContactsOfManySizes)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::WALLED})
    expectSameContacts(scarce(60, {0.3, 0.3, 0.5, 2.1, 3.0, 4.5, 6.0}, boundary), 0.09, 0.0, 200);
}

TEST(WideSizes, MeetTheSameContactsWhileTheBaseTurns)
{
  for (const double rate : {0.3, 2.0})
    for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN})
    {
      SCOPED_TRACE(std::to_string(rate) + " rad/s, " + std::to_string(static_cast<int>(boundary)));
      expectSameContacts(scarce(60, {2.5, 7.0}, boundary), 0.09, rate, 200);
    }
}

TEST(WideSizes, MeetTheSameContactsOnAProfileInBothFramesOfTheDrive)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED})
    for (const DriveFrame frame : {DriveFrame::WORLD, DriveFrame::BASE})
    {
      SCOPED_TRACE(std::to_string(static_cast<int>(boundary)) + ", " +
                   std::to_string(static_cast<int>(frame)));
      SceneDefinition scene = test::onAnOrbit(scarce(60, {0.4, 2.5, 8.0}, boundary));
      scene.base.profile = test::castle();
      scene.base.inclination = 0.2;
      scene.base.drive_frame = frame;
      expectSameContacts(scene, 0.08, 0.0, 150);
    }
}

/// With steps so short that hardly a contact is missed.
TEST(WideSizes, MeetTheSameContactsBySteps)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN})
  {
    SceneDefinition scene = scarce(60, {2.5, 8.0}, boundary);
    scene.accuracy.method = Method::STEPS;
    scene.accuracy.step = 1e-5;
    expectSameContacts(scene, 0.05, 0.0, 80);
  }
}

/// In all boundaries, with setpoints and pours of large disks.
TEST(WideSizes, OverlapNever)
{
  for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN, Boundary::WALLED})
  {
    SCOPED_TRACE(static_cast<int>(boundary));
    SceneDefinition scene = test::lognormalSizes(300, 0.5);
    scene.species.push_back(test::disksOfSize(20.0, 1));
    scene.base.teeth = 9;
    scene.boundary = boundary;
    ASSERT_GT(levelsOf(scene), 1u);
    Simulation simulation(scene);
    for (const double inclination : {0.05, 0.0})
    {
      const double start = simulation.time();
      simulation.command(Quantity::INCLINATION, inclination);
      simulation.advanceTo(start + 0.3);
      simulation.pour(scene.species.size() - 1, 1);
      simulation.advanceTo(start + 0.7);
    }
    EXPECT_EQ(simulation.auditOverlaps(), 0u);
    EXPECT_LT(simulation.maxOverlap(), 1e-9 * scene.species[0].radius);
  }
}

}  // namespace
}  // namespace ratchet_sieve
