// The standard error of <V_x> is the scatter of runs, also of runs that are short.
#include <cmath>

#include <gtest/gtest.h>

#include "coverage.h"
#include "ratchet_sieve/core/simulation.h"
#include "small_scenes.h"

namespace ratchet_sieve
{
namespace
{

constexpr int RUNS = 100;

/// The mixture of Fig. 8 on two teeth: 26 disks of each species.
SceneDefinition shortRun()
{
  SceneDefinition scene = smallRing();
  scene.base.teeth = 2;
  scene.base.asymmetry = 0.3;
  scene.species[0].count = scene.species[1].count = 26;
  scene.species[1].radius = 0.002;
  scene.settle = 1.0;
  scene.duration = 4.0;
  return scene;
}

TEST(ShortRuns, HaveErrorsAsLargeAsTheirScatter)
{
  SceneDefinition scene = shortRun();
  std::vector<SpeciesMeans> runs[2];
  for (scene.seed = 1; scene.seed <= RUNS; ++scene.seed)
  {
    Simulation simulation(scene);
    simulation.advanceTo(scene.duration);
    for (int s = 0; s < 2; ++s)
      runs[s].push_back(simulation.means()[static_cast<std::size_t>(s)]);
  }
  for (const std::vector<SpeciesMeans>& species : runs)
  {
    double mean = 0.0, scatter = 0.0, squared = 0.0;
    for (const SpeciesMeans& run : species)
      mean += *run.mean_vx / RUNS;
    Coverage coverage;
    for (const SpeciesMeans& run : species)
    {
      ASSERT_TRUE(run.mean_vx_stderr);
      const double off = *run.mean_vx - mean;
      scatter += off * off / (RUNS - 1);
      squared += *run.mean_vx_stderr * *run.mean_vx_stderr / RUNS;
      coverage.take(std::abs(off) <= 1.96 * *run.mean_vx_stderr);
    }
    // The scatter of so many runs is known to 7 %.
    EXPECT_NEAR(std::sqrt(squared / scatter), 1.0, 0.14);
    EXPECT_GT(coverage.share(), 0.89);
  }
}

}  // namespace
}  // namespace ratchet_sieve
