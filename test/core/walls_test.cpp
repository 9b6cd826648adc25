#include "ratchet_sieve/core/disks_of_scene.h"

#include <cmath>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
constexpr double HEIGHT = 0.05;  // of the walls [m]
constexpr double DISK_RADIUS = 0.001;

/// A walled base at rest without gravity, and one elastic disk that flies to the right, `above` the top of
/// the walls.
SceneDefinition thrownOver(double above)
{
  SceneDefinition scene = test::mixture(0);
  scene.boundary = Boundary::WALLED;
  scene.gravity = 0.0;
  scene.base.amplitude = 0.0;
  scene.base.wall_height = HEIGHT;
  scene.species[0].contact = {1.0, 0.5, 0.5};
  scene.initial = {{0, scene.base.width() - 0.1, HEIGHT + above, 1.0, 0.0, 7.0}};
  return scene;
}

TEST(Walls, ADiskStrikesTheTopOfAWall)
{
  // Half a radius above it: the normal is 30 degrees above the horizontal.
  Simulation simulation(thrownOver(0.5 * DISK_RADIUS));
  const auto records = test::collisionsUntil(simulation, 0.2);
  ASSERT_EQ(records.size(), 1u);
  const double cosine = std::sqrt(0.75);
  EXPECT_EQ(records[0].kind, CollisionKind::WALL);
  EXPECT_NEAR(records[0].time, 0.1 - cosine * DISK_RADIUS, 1e-15);
  EXPECT_NEAR(records[0].normal_speed, cosine, 1e-12);
  // A wall and its end are smooth: the spin and the tangential speed are unchanged.
  const DiskState disk = simulation.disks().front();
  EXPECT_NEAR(disk.vx, 1.0 - 2.0 * cosine * cosine, 1e-12);
  EXPECT_NEAR(disk.vy, 2.0 * cosine * 0.5, 1e-12);
  EXPECT_EQ(disk.spin, 7.0);
}

TEST(Walls, BelowItsTopAWallIsFlat)
{
  Simulation simulation(thrownOver(-1e-9));
  simulation.advanceTo(0.2);
  EXPECT_EQ(simulation.collisions().wall, 1u);
  EXPECT_EQ(simulation.disks().front().vx, -1.0);
  EXPECT_EQ(simulation.disks().front().vy, 0.0);
}

TEST(Walls, ADiskThatClearsAWallIsCountedBehindIt)
{
  Simulation simulation(thrownOver(DISK_RADIUS + 1e-12));
  simulation.advanceTo(0.1 - 1e-12);
  EXPECT_EQ(simulation.activeDisks(), 1u);
  simulation.advanceTo(0.1 + 1e-12);
  EXPECT_EQ(simulation.activeDisks(), 0u);
  EXPECT_EQ(simulation.collisions().total(), 0u);
  EXPECT_EQ(simulation.bins()[0].right, 1u);
  EXPECT_EQ(simulation.bins()[0].left, 0u);
}

TEST(Walls, HaveAHeightOfTheirOwnUnlessTheSceneSaysOne)
{
  SceneDefinition scene = test::mixture(50);
  scene.boundary = Boundary::WALLED;
  const double squares = 50 * (0.002 * 0.002 + 0.004 * 0.004);
  EXPECT_NEAR(wallHeight(scene), 10 * 0.4 + 0.006 + 0.02 + 0.004 + 2.0 * squares / 0.4, 1e-12);
  scene.base.wall_height = 0.3;
  EXPECT_EQ(wallHeight(scene), 0.3);
}

}  // namespace
}  // namespace ratchet_sieve
