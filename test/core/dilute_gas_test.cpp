#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "reference_loop.h"
#include "runs.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Disks that a strong drive throws to heights of metres, so that they mostly have no neighbours.
SceneDefinition gas(int count, int teeth, double amplitude)
{
  SceneDefinition scene = test::mixture(count);
  scene.base.teeth = teeth;
  scene.base.amplitude = amplitude;
  return scene;
}

/// A scene that begins at the run's present state. @param ids of its disks in the run
SceneDefinition sceneAt(const Simulation& simulation, std::vector<std::uint32_t>& ids)
{
  SceneDefinition scene = simulation.scene();
  scene.base.phase = simulation.base().phase;
  scene.base.inclination = simulation.base().inclination;
  scene.feed.rate = 0.0;
  scene.initial.clear();
  for (const DiskState& disk : simulation.disks())
  {
    scene.initial.push_back({disk.species, disk.x, disk.y, disk.vx, disk.vy, disk.spin});
    ids.push_back(disk.id);
  }
  for (SpeciesDefinition& species : scene.species)
    species.count = 0;
  return scene;
}

/// Continues the run, and in parallel the reference loop, which tests all pairs. All collisions must agree
/// until rounding errors have grown too large.
/// @param span how long [s]
void expectSameCollisionsFromHere(Simulation& run, double span, const test::Turn& turn)
{
  constexpr int IMAGES = 8;
  std::vector<std::uint32_t> ids;
  const SceneDefinition scene = sceneAt(run, ids);
  // Disks are told within the width: two are no further apart, and come no closer than this.
  for (const InitialDisk& disk : scene.initial)
    ASSERT_LT(2.0 * std::hypot(disk.vx, disk.vy) * span, (IMAGES - 1) * scene.base.width());
  const double start = run.time();
  if (turn.rate > 0.0)
  {
    run.setSlewRates(turn.slewRates());
    run.command(Quantity::INCLINATION, turn.inclination);
  }
  std::vector<CollisionRecord> slow;
  const auto take = [&](CollisionRecord record)
  {
    record.time += start;
    record.i = ids[record.i];
    if (record.j)
      record.j = ids[*record.j];
    slow.push_back(record);
  };
  test::runReference(scene, span, take, turn, IMAGES);
  SCOPED_TRACE("from " + std::to_string(start) + " s");
  test::expectSameContacts(test::collisionsUntil(run, start + span), slow, 1e-6);
}

/// A comparison of a gas with the reference.
struct Check
{
  const char* name;
  SceneDefinition scene;
  double events_per_collision;  ///< upper limit
  double warm_up = 3.0;         ///< [s]
  double swing = 0.0;           ///< amplitude of the inclination of a base that turns to and fro [rad]
};

/// Compares a run with the reference several times, and counts its events per collision.
void expectNothingMissed(const Check& check)
{
  constexpr double SPAN = 0.015;
  constexpr double BETWEEN = 0.05;
  constexpr int TIMES = 40;
  Simulation run(check.scene);
  run.advanceTo(check.warm_up);
  const std::uint64_t events = run.events();
  const std::uint64_t collisions = run.collisions().total();
  for (int time = 0; time < TIMES; ++time)
  {
    const test::Turn turn{check.swing > 0.0 ? 1.0 : 0.0, time % 2 == 0 ? check.swing : -check.swing};
    ASSERT_NO_FATAL_FAILURE(expectSameCollisionsFromHere(run, SPAN, turn));
    run.advanceTo(run.time() + BETWEEN);
    test::expectNoOverlap(run);
  }
  const double done = static_cast<double>(run.collisions().total() - collisions);
  EXPECT_GT(done, 100.0);
  EXPECT_LT(static_cast<double>(run.events() - events), check.events_per_collision * done);
}

TEST(DiluteGas, MissesNothing)
{
  const SceneDefinition ring = gas(30, 10, 0.1);
  SceneDefinition inclined = gas(30, 10, 0.05);
  inclined.base.inclination = 0.3;
  SceneDefinition walled = ring;
  walled.boundary = Boundary::WALLED;
  walled.base.wall_height = 1000.0;
  SceneDefinition open = gas(60, 1000, 0.05);
  open.boundary = Boundary::OPEN;
  for (const Check& check : {Check{"ring", ring, 10.0}, Check{"inclined ring", inclined, 10.0},
                             Check{"wide ring", gas(40, 100, 0.05), 15.0}, Check{"walled", walled, 5.0},
                             Check{"open", open, 10.0, 2.0}, Check{"open, turning", open, 100.0, 2.0, 0.1}})
  {
    SCOPED_TRACE(check.name);
    expectNothingMissed(check);
  }
}

/// The lattice turns relative to the cells, and a disk that went round the ring many times must be wrapped
/// back. Images are not in free flight then, so a restarted run would be a different one. Instead, the run is
/// audited so often that no two disks can pass through each other unnoticed.
TEST(DiluteGas, MissesNothingWhileTheRingTurnsAndStandsInTurns)
{
  constexpr double LOOK = 1e-4;
  Simulation simulation(gas(20, 10, 0.05));
  simulation.setSlewRates({1.0, 10.0, 0.002});
  simulation.advanceTo(3.0);
  for (int swing = 0; swing < 10; ++swing)
  {
    // 0.1 s of turning, then 0.1 s at rest.
    simulation.command(Quantity::INCLINATION, swing % 2 == 0 ? 0.1 : 0.0);
    const double start = simulation.time();
    for (int look = 1; look <= 2000; ++look)
    {
      simulation.advanceTo(start + LOOK * look);
      ASSERT_EQ(simulation.auditOverlaps(), 0u);
    }
  }
  EXPECT_GT(simulation.collisions().disk_disk, 20u);
  EXPECT_LT(simulation.maxOverlap(), 1e-12);
}

/// Without losses, disks get faster and higher, and have fewer neighbours.
TEST(DiluteGas, CostsNoMoreTheHigherItFlies)
{
  SceneDefinition scene = gas(5, 10, 0.01);
  for (SpeciesDefinition& species : scene.species)
    species.contact.restitution = 1.0;
  scene.contact.min_rebound_speed = 0.0;
  Simulation simulation(scene);
  simulation.advanceTo(100.0);
  const double early = static_cast<double>(simulation.events());
  const double early_collisions = static_cast<double>(simulation.collisions().total());
  EXPECT_LT(early, 10.0 * early_collisions);
  simulation.advanceTo(400.0);
  EXPECT_LT(static_cast<double>(simulation.events()) - early,
            10.0 * (static_cast<double>(simulation.collisions().total()) - early_collisions));
  EXPECT_EQ(simulation.auditOverlaps(), 0u);
}

/// Cells chosen for a gas are too large for the layer that it condenses to.
TEST(DiluteGas, CellsShrinkAgainWhereItCondenses)
{
  const auto near = [](const SceneDefinition& scene, double hot, double amplitude)
  {
    Simulation simulation(scene);
    simulation.setSlewRates({1.0, 10.0, 1.0});
    simulation.advanceTo(hot);
    simulation.command(Quantity::AMPLITUDE, amplitude);
    simulation.advanceTo(hot + 10.0);
    return simulation.saveState().size();
  };
  // The state includes the cells: their size must be that of a run that was never hot, apart from the disks
  // that they contain.
  const SceneDefinition scene = gas(60, 10, 0.1);
  SceneDefinition calm = scene;
  calm.base.amplitude = 0.002;
  const auto of_gas = static_cast<double>(near(scene, 5.0, 0.1));
  const auto condensed = static_cast<double>(near(scene, 5.0, 0.002));
  const auto never_hot = static_cast<double>(near(calm, 5.0, 0.002));
  EXPECT_LT(of_gas, 0.95 * never_hot);
  EXPECT_NEAR(condensed / never_hot, 1.0, 0.02);
}

}  // namespace
}  // namespace ratchet_sieve
