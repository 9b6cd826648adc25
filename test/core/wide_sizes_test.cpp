// Scenes with sizes so wide that their cells are nested.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"
#include "search/size_levels.h"

namespace ratchet_sieve
{
namespace
{

std::size_t levelsOf(const SceneDefinition& scene)
{
  const Simulation simulation(scene);
  std::vector<double> radii;
  for (const DiskState& disk : simulation.disks())
    radii.push_back(scene.species[disk.species].radius);
  return cheapestLevels(radii, 2.0 * *std::max_element(radii.begin(), radii.end())).count();
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
