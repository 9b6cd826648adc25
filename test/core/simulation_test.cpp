#include "ratchet_sieve/core/simulation.h"

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "runs.h"
#include "scenes.h"
#include "state_hash.h"

namespace ratchet_sieve
{
namespace
{

TEST(Simulation, NothingIsCountedBeforeSettle)
{
  SceneDefinition scene = test::mixture(20);
  scene.settle = 5.0;
  Simulation simulation(scene);
  simulation.advanceTo(4.9);
  EXPECT_FALSE(simulation.means()[0].mean_vx);
  EXPECT_FALSE(simulation.means()[0].collision_rate);
  EXPECT_EQ(simulation.baseImpulse().y(), 0.0);
  simulation.advanceTo(5.1);
  EXPECT_TRUE(simulation.means()[0].mean_vx);
  EXPECT_GT(simulation.baseImpulse().y(), 0.0);
}

TEST(Simulation, TimesThatAreNoneOrEarlierDoNothing)
{
  Simulation simulation(test::mixture(5));
  simulation.advanceTo(1.0);
  const auto hash = test::stateHash(simulation);
  simulation.advanceTo(0.5);
  simulation.advanceTo(std::nan(""));
  EXPECT_EQ(simulation.time(), 1.0);
  EXPECT_EQ(test::stateHash(simulation), hash);
}

TEST(Simulation, DisksThatStartManyLapsAwayMeetAllTheSame)
{
  for (const int laps : {0, 1, -1, 2, 5, -3})
  {
    SceneDefinition scene = test::mixture(0);
    scene.base.amplitude = 0.0;
    const double x = 0.1 + laps * scene.base.width();
    scene.initial = {{0, x, 0.05, 0, 0, 0}, {0, 0.1, 0.08, 0, -1.0, 0}};
    Simulation simulation(scene);
    simulation.advanceTo(0.05);
    EXPECT_EQ(simulation.collisions().disk_disk, 1u) << laps;
    simulation.auditOverlaps();
    EXPECT_LT(simulation.maxOverlap(), 1e-14) << laps;
  }
}

TEST(Simulation, ASlowDriveIsNoCollapse)
{
  SceneDefinition scene = test::singleParticles(1);
  scene.base.frequency = 1e-4;
  Simulation simulation(scene);
  simulation.advanceTo(9000.0);
  EXPECT_GT(simulation.collisions().total(), 100000u);
}

TEST(Simulation, PouringWhereThereIsNoRoomIsRefused)
{
  SceneDefinition scene = test::mixture(0);
  scene.base.teeth = 1;
  scene.species[1].radius = 0.015;
  Simulation simulation(scene);
  EXPECT_THROW(simulation.pour(1, 1), std::invalid_argument);
  EXPECT_THROW(simulation.pour(2, 1), std::invalid_argument);
  EXPECT_EQ(simulation.activeDisks(), 0u);
}

TEST(Simulation, ALaterPourThatIsRefusedOrCancelledChangesNothing)
{
  Simulation simulation(test::mixture(30));
  simulation.advanceTo(0.1);
  const std::string before = simulation.saveState();
  EXPECT_THROW(simulation.pour(0, MOST_DISKS - 59), std::invalid_argument);
  EXPECT_THROW(simulation.pour(0, std::size_t{1} << 63), std::invalid_argument);
  EXPECT_THROW(simulation.pour(0, 2000, {}, [](std::size_t poured, std::size_t /*of*/) { throw poured; }),
               std::size_t);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Stretch& wrong : {Stretch{-0.01, 0.1}, Stretch{0.2, 0.1}, Stretch{7.0, 8.0}, Stretch{nan, nan}})
    EXPECT_THROW(simulation.pour(0, 1, wrong), std::invalid_argument);
  EXPECT_EQ(simulation.saveState(), before);
}

TEST(Simulation, APourBetweenTwoPlacesIsBetweenThem)
{
  Simulation simulation(test::mixture(0));
  simulation.pour(1, 50, Stretch{0.1, 0.12});
  ASSERT_EQ(simulation.activeDisks(), 50u);
  for (const DiskState& disk : simulation.disks())
  {
    EXPECT_GE(disk.x, 0.1);
    EXPECT_LE(disk.x, 0.12);
  }
}

TEST(Simulation, DisplacementIsUnwrappedAndPlacesAreNot)
{
  SceneDefinition scene = test::singleParticles(50);
  scene.base.teeth = 2;
  Simulation simulation(scene);
  simulation.advanceTo(20.0);
  double farthest = 0.0;
  for (const DiskState& disk : simulation.disks())
  {
    EXPECT_GE(disk.x, 0.0);
    EXPECT_LE(disk.x, 0.04);
    farthest = std::max(farthest, disk.displacement);
  }
  EXPECT_GT(farthest, 0.5);
}

std::string refusal(const SceneDefinition& scene)
{
  try
  {
    Simulation simulation(scene);
  }
  catch (const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(Simulation, RefusesABadStartAndNamesTheDisks)
{
  SceneDefinition scene = test::mixture(0);
  scene.initial = {{0, 0.1, 0.05, 0, 0, 0}, {1, 0.2, 0.05, 0, 0, 0}, {1, 0.1025, 0.05, 0, 0, 0}};
  EXPECT_EQ(refusal(scene), "initial.0 and initial.2 overlap by 0.0005 m");
  scene.initial = {{0, 0.1, 0.0005, 0, 0, 0}};
  EXPECT_NE(refusal(scene).find("initial.0 overlaps the base"), std::string::npos);
  scene.initial = {{0, 0.1, 0.05, 0, 0, 0}, {0, 0.5, 0.05, 0, 0, 0}};
  scene.boundary = Boundary::OPEN;
  EXPECT_NE(refusal(scene).find("initial.1 is outside"), std::string::npos);
  scene.initial = {{0, 0.1, 0.007, 0, 0, 0}};
  EXPECT_EQ(refusal(scene), "");
}

TEST(Simulation, DisksThatTouchAreALegalStartEvenFarFromTheOrigin)
{
  SceneDefinition scene = test::mixture(0);
  scene.base.teeth = 500;
  for (int k = 0; k < 1000; ++k)
    scene.initial.push_back({0, 0.002 * k + 4.0, 0.05, 0.0, 0.0, 0.0});
  EXPECT_EQ(refusal(scene), "");
  scene.initial.push_back({0, 5.9979, 0.05, 0.0, 0.0, 0.0});
  EXPECT_NE(refusal(scene).find("initial.1000 overlap by 0.0019 m"), std::string::npos) << refusal(scene);
}

TEST(Simulation, DisksThatRestAgainstAWallAreFree)
{
  // Nothing moves them towards the wall that they touch: there is no event.
  SceneDefinition scene = test::mixture(0);
  scene.boundary = Boundary::WALLED;
  scene.base.amplitude = 0.0;
  scene.initial = {{0, 0.001, 1.0, 0.0, 0.0, 0.0}, {1, 0.398, 1.0, 0.0, 0.0, 0.0}};
  Simulation falling(scene);
  falling.advanceTo(0.4);
  EXPECT_EQ(falling.collisions().total(), 0u);
  EXPECT_LT(falling.events(), 100u);
  scene.gravity = 0.0;
  scene.initial[0].y = scene.base.tooth_height + 0.001;
  scene.initial[0].x = scene.base.asymmetry * scene.base.tooth_width;
  Simulation floating(scene);
  floating.advanceTo(10.0);
  EXPECT_EQ(floating.collisions().total(), 0u);
  EXPECT_LT(floating.events(), 1000u);
}

TEST(Simulation, SmallDisksFarFromEachOtherTouchAsExactlyAsNearOnes)
{
  SceneDefinition scene = test::mixture(60);
  scene.species[0].radius = 1e-6;
  scene.species[1].radius = 2e-6;
  Simulation simulation(scene);
  simulation.advanceTo(20.0);
  EXPECT_GT(simulation.collisions().disk_disk, 10u);
  EXPECT_LT(simulation.maxOverlap(), 1e-9 * 1e-6);
}

}  // namespace
}  // namespace ratchet_sieve
