#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "reference_loop.h"
#include "scenes.h"
#include "state/placement.h"

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

/// The collisions of a run, and the data for continuing the run by another method.
struct Watched
{
  explicit Watched(const SceneDefinition& scene) : simulation(scene)
  {
    simulation.observeCollisions([this](const CollisionRecord& record) { records.push_back(record); });
  }

  Simulation simulation;
  std::vector<CollisionRecord> records;
};

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
/// @param turn inclination to turn to meanwhile, at 1 rad/s
void expectSameCollisionsFromHere(Watched& run, double span, std::optional<double> turn)
{
  std::vector<std::uint32_t> ids;
  const SceneDefinition scene = sceneAt(run.simulation, ids);
  test::Bench bench(scene);
  placeInitialDisks(bench.state, 0.0);
  std::vector<CollisionRecord> expected;
  bench.state.observers().observeCollisions([&](const CollisionRecord& record)
                                            { expected.push_back(record); });
  if (turn)
  {
    test::turn(bench.state, 1.0, *turn, 0.0);
    run.simulation.setSlewRates({1.0, 10.0, 0.002});
    run.simulation.command(Quantity::INCLINATION, *turn);
  }
  constexpr int IMAGES = 40;
  test::ReferenceLoop(bench, IMAGES).advanceTo(span);

  const double start = run.simulation.time();
  run.records.clear();
  run.simulation.advanceTo(start + span);
  ASSERT_EQ(run.records.size(), expected.size()) << "from " << start;
  const auto partners = [](std::uint32_t i, std::uint32_t j) -> std::pair<std::uint32_t, std::uint32_t>
  { return std::minmax(i, j); };
  for (std::size_t k = 0; k < expected.size(); ++k)
  {
    const CollisionRecord& is = run.records[k];
    const CollisionRecord& was = expected[k];
    const std::uint32_t i = ids[was.i];
    const std::uint32_t j = ids[was.j.value_or(was.i)];
    ASSERT_NEAR(is.time - start, was.time, 1e-6) << "collision " << k << " from " << start;
    ASSERT_EQ(is.kind, was.kind) << "collision " << k << " from " << start;
    ASSERT_EQ(partners(is.i, is.j.value_or(is.i)), partners(i, j));
  }
}

/// The parameters of a comparison of a gas with the reference.
struct Check
{
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
  EXPECT_LT(simulation.maxOverlap(), 1e-9 * 0.001);
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
