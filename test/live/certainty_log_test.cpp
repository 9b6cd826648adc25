#include "ratchet_sieve/live/certainty_log.h"

#include <gtest/gtest.h>

#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

SceneDefinition asking(double mean_vx)
{
  SceneDefinition scene = smallRing();
  scene.contact.pair_collisions = false;
  scene.species[0].count = scene.species[1].count = 64;
  scene.accuracy.mean_vx = mean_vx;
  return scene;
}

/// Number of log lines of a run that is checked every 0.1 s.
int linesOf(CertaintyLog& log, const SceneDefinition& scene, double start, double duration)
{
  Simulation simulation(scene, start);
  int lines = 0;
  for (double time = 0.0; time < duration; time += 0.1)
  {
    simulation.advanceTo(start + time);
    lines += log.line(simulation) ? 1 : 0;
  }
  return lines;
}

TEST(CertaintyLog, SaysOnceThatARunIsSureEnough)
{
  CertaintyLog log;
  EXPECT_EQ(linesOf(log, asking(0.1), 0.0, 40.0), 1);
  EXPECT_EQ(linesOf(log, asking(0.1), 0.0, 40.0), 1) << "of a run that begins anew at time 0";
  EXPECT_EQ(linesOf(log, asking(0.1), 40.0, 40.0), 1) << "and of one whose time goes on";
}

TEST(CertaintyLog, SaysNothingOfARunThatIsNotOrDoesNotAsk)
{
  CertaintyLog log;
  EXPECT_EQ(linesOf(log, asking(1e-7), 0.0, 40.0), 0);
  EXPECT_EQ(linesOf(log, asking(0.0), 0.0, 40.0), 0);
}

}  // namespace
}  // namespace ratchet_sieve
