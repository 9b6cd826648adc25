#include "ratchet_sieve/live/wall_log.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{
/// Without gravity, `count` disks above the left wall fly over it, one every millisecond.
Simulation flownOver(int count, Boundary boundary = Boundary::WALLED)
{
  SceneDefinition scene = smallMixture();
  scene.boundary = boundary;
  scene.gravity = 0.0;
  scene.base.wall_height = 0.05;
  for (int k = 1; k <= count; ++k)
    scene.initial.push_back({0, 0.01 * k, 0.1, -10.0, 0.0, 0.0});
  return Simulation(scene);
}

TEST(WallLog, SaysTheFirstAndEachDoubling)
{
  Simulation simulation = flownOver(5);
  WallLog log;
  std::vector<std::string> lines;
  for (int k = 0; k <= 6; ++k)
  {
    simulation.advanceTo(0.0005 + 0.001 * k);
    if (const auto line = log.line(simulation))
      lines.push_back(*line);
    EXPECT_FALSE(log.line(simulation)) << "the same again";
  }
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0],
            "1 of the disks went over the walls, which are 0.05 m high: 1 to the left, 0 to the right; "
            "base.wall_height makes them higher");
  EXPECT_EQ(lines[1].substr(0, 4), "2 of");
  EXPECT_EQ(lines[2].substr(0, 4), "4 of");
}

TEST(WallLog, BeginsAnewWithARun)
{
  Simulation simulation = flownOver(3);
  simulation.advanceTo(0.01);
  WallLog log;
  EXPECT_TRUE(log.line(simulation));
  Simulation next = flownOver(1);
  EXPECT_FALSE(log.line(next));
  next.advanceTo(0.01);
  EXPECT_TRUE(log.line(next));
}

TEST(WallLog, SaysNothingOfOpenEnds)
{
  Simulation simulation = flownOver(3, Boundary::OPEN);
  simulation.advanceTo(0.01);
  EXPECT_EQ(simulation.bins()[0].left, 3u);
  EXPECT_FALSE(WallLog().line(simulation));
}
}  // namespace
}  // namespace ratchet_sieve
