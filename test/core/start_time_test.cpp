#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
TEST(StartTime, IsWhereTimeCountsFrom)
{
  // Rounding errors of contact times grow as in any run: about tenfold per collision of a disk.
  constexpr double SOON = 0.03;  // s
  constexpr double NEAR = 1e-9;
  SceneDefinition scene = test::mixture(20);
  scene.feed.rate = 20.0;
  Simulation at_zero(scene);
  at_zero.advanceTo(SOON);
  for (const double start : {0.3, 7.77, 12345.678})
  {
    Simulation later(scene, start);
    EXPECT_EQ(later.time(), start);
    EXPECT_EQ(later.startTime(), start);
    later.advanceTo(start + SOON);
    const std::vector<DiskState> expected = at_zero.disks();
    const std::vector<DiskState> disks = later.disks();
    ASSERT_EQ(disks.size(), expected.size());
    for (std::size_t k = 0; k < disks.size(); ++k)
    {
      EXPECT_NEAR(disks[k].x, expected[k].x, NEAR);
      EXPECT_NEAR(disks[k].y, expected[k].y, NEAR);
    }
    // time() is exactly the requested time, in any epoch.
    for (int k = 1; k < 60; ++k)
    {
      later.advanceTo(start + k / 7.0);
      ASSERT_EQ(later.time(), start + k / 7.0);
    }
    EXPECT_EQ(later.auditOverlaps(), 0u);
  }
}
}  // namespace
}  // namespace ratchet_sieve
