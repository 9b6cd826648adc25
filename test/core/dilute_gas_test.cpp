#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "reference_loop.h"
#include "scenes.h"
#include "state/machine.h"
#include "state/placement.h"

namespace ratchet_sieve
{
namespace
{
/// Disks that a strong drive throws metres high, so that most of their way nothing is near.
SceneDefinition gas(int count, int teeth, double amplitude)
{
  SceneDefinition scene = test::mixture(count);
  scene.base.teeth = teeth;
  scene.base.amplitude = amplitude;
  return scene;
}

/// The collisions of a run, and what of it is needed to run on from an instant in another way.
struct Watched
{
  explicit Watched(const SceneDefinition& scene) : simulation(scene)
  {
    simulation.observeCollisions([this](const CollisionRecord& record) { records.push_back(record); });
  }

  Simulation simulation;
  std::vector<CollisionRecord> records;
};

/// The scene that begins as the run stands. @param ids of its disks in the run
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

/// Runs on from where the run stands, and beside it the slow reference, which tests all pairs: collision
/// for collision the same, as far as the collisions of a disk have not yet let roundings grow.
/// @param turn to this inclination meanwhile, at 1 rad/s
void expectSameCollisionsFromHere(Watched& run, double span, std::optional<double> turn)
{
  std::vector<std::uint32_t> ids;
  const SceneDefinition scene = sceneAt(run.simulation, ids);
  Machine machine(scene);
  placeInitialDisks(machine, 0.0);
  std::vector<CollisionRecord> expected;
  machine.record().observeCollisions([&](const CollisionRecord& record) { expected.push_back(record); });
  if (turn)
  {
    machine.state().motion().setSlewRates({1.0, 10.0, 0.002}, 0.0);
    machine.state().motion().command(Quantity::INCLINATION, *turn, 0.0);
    run.simulation.setSlewRates({1.0, 10.0, 0.002});
    run.simulation.command(Quantity::INCLINATION, *turn);
  }
  constexpr int IMAGES = 40;
  test::ReferenceLoop(machine, IMAGES).advanceTo(span);

  const double start = run.simulation.time();
  run.records.clear();
  run.simulation.advanceTo(start + span);
  ASSERT_EQ(run.records.size(), expected.size()) << "from " << start;
  const auto partners = [](std::uint32_t i, std::uint32_t j) { return std::minmax(i, j); };
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    const CollisionRecord& is = run.records[k];
    const CollisionRecord& was = expected[k];
    const std::uint32_t i = ids[was.i];
    const std::uint32_t j = ids[was.j.value_or(was.i)];
    ASSERT_NEAR(is.time - start, was.time, 1e-6) << "collision " << k << " from " << start;
    ASSERT_EQ(is.kind, was.kind) << "collision " << k << " from " << start;
    ASSERT_EQ(std::pair(partners(is.i, is.j.value_or(is.i))), std::pair(partners(i, j)));
  }
}

/// What a gas is held against the reference with.
struct Check
{
  SceneDefinition scene;
  double events_per_collision;  ///< that it may take at most
  double warm_up = 3.0;         ///< [s]
  double swing = 0.0;           ///< where the base turns to and fro between this and its negative [rad]
};

/// Holds a run against the reference again and again, and counts what it did for a collision.
void expectNothingMissed(const Check& check)
{
  constexpr double SPAN = 0.015;
  constexpr double BETWEEN = 0.05;
  constexpr int TIMES = 40;
  Watched run(check.scene);
  run.simulation.advanceTo(check.warm_up);
  const std::uint64_t events = run.simulation.events();
  const std::uint64_t collisions = run.simulation.collisions().total();
  for (int time = 0; time < TIMES; ++time)
  {
    std::optional<double> turn;
    if (check.swing > 0.0)
      turn = time % 2 == 0 ? check.swing : -check.swing;
    ASSERT_NO_FATAL_FAILURE(expectSameCollisionsFromHere(run, SPAN, turn));
    run.simulation.advanceTo(run.simulation.time() + BETWEEN);
    ASSERT_EQ(run.simulation.auditOverlaps(), 0u);
  }
  EXPECT_LT(run.simulation.maxOverlap(), 1e-9 * 0.001);
  const double done = static_cast<double>(run.simulation.collisions().total() - collisions);
  EXPECT_GT(done, 100.0);
  EXPECT_LT(static_cast<double>(run.simulation.events() - events), check.events_per_collision * done);
}

TEST(DiluteGas, MissesNothingOnARing)
{
  expectNothingMissed({gas(30, 10, 0.1), 10.0});
}

TEST(DiluteGas, MissesNothingOnAnInclinedRing)
{
  SceneDefinition scene = gas(30, 10, 0.05);
  scene.base.inclination = 0.3;
  expectNothingMissed({scene, 10.0});
}

TEST(DiluteGas, MissesNothingOnAWideRing)
{
  expectNothingMissed({gas(40, 100, 0.05), 15.0});
}

TEST(DiluteGas, MissesNothingBetweenWalls)
{
  SceneDefinition scene = gas(30, 10, 0.1);
  scene.boundary = Boundary::WALLED;
  scene.base.wall_height = 1000.0;
  expectNothingMissed({scene, 5.0});
}

TEST(DiluteGas, MissesNothingOnAnOpenBase)
{
  SceneDefinition scene = gas(60, 1000, 0.05);
  scene.boundary = Boundary::OPEN;
  expectNothingMissed({scene, 10.0, 2.0});
}

TEST(DiluteGas, MissesNothingOnAnOpenBaseThatTurns)
{
  SceneDefinition scene = gas(60, 1000, 0.05);
  scene.boundary = Boundary::OPEN;
  expectNothingMissed({scene, 100.0, 2.0, 0.1});
}

/// The lattice turns against the cells, and a disk that went round the ring many times has to be brought
/// home. Its images do not fly freely then, so that a run that begins anew would be another: looked at so
/// often instead that no two disks can pass through each other unseen.
TEST(DiluteGas, MissesNothingWhileTheRingTurnsAndStandsInTurns)
{
  constexpr double LOOK = 1e-4;
  Simulation simulation(gas(20, 10, 0.05));
  simulation.setSlewRates({1.0, 10.0, 0.002});
  simulation.advanceTo(3.0);
  for (int swing = 0; swing < 10; ++swing)
  {
    // 0.1 s to turn, and as long to stand.
    simulation.command(Quantity::INCLINATION, swing % 2 == 0 ? 0.1 : 0.0);
    const double start = simulation.time();
    for (int look = 1; look <= 2000; ++look)
    {
      simulation.advanceTo(start + LOOK * look);
      ASSERT_EQ(simulation.auditOverlaps(), 0u);
    }
  }
  EXPECT_GT(simulation.collisions().disk_disk, 20u);
  EXPECT_LT(simulation.maxOverlap(), 1e-9 * 0.001);
}

/// Where nothing is lost disks get ever faster and higher, and there is ever less that they touch.
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

/// Cells that were laid for a gas are too large for the layer that it becomes.
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
  // The state holds the cells: as many as for a run that was never hot, within what both happen to hold.
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
