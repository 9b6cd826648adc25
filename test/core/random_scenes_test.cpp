#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "drawn_scene.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/core/sizes.h"

namespace ratchet_sieve
{
namespace
{

void checkState(Simulation& simulation)
{
  const std::size_t behind = simulation.auditOverlaps();
  if (!simulation.plan().steps)
  {
    RC_ASSERT(behind == 0u);
    const double smallest = smallestRadius(simulation.scene());
    // The resolution of a double at positions of a few metres and speeds of about ten m/s.
    const double rounding = 1e-13;
    RC_ASSERT(simulation.maxOverlap() <= 1e-9 * smallest + rounding);
  }
  std::uint64_t on_base = 0;
  for (const SpeciesBins& bins : simulation.bins())
    on_base += bins.on_base;
  RC_ASSERT(on_base == simulation.activeDisks());
  for (const DiskState& disk : simulation.disks())
    for (const double value : {disk.x, disk.y, disk.vx, disk.vy, disk.angle, disk.spin, disk.displacement})
      RC_ASSERT(std::isfinite(value));
  RC_ASSERT(std::isfinite(simulation.energy()));
  if (!simulation.scene().base.profile.empty())
  {
    const CollisionCounts& counts = simulation.collisions();
    const FaceContacts& parts = simulation.faceContacts();
    const auto sum = [](const auto& list) { return std::accumulate(list.begin(), list.end(), 0ull); };
    RC_ASSERT(sum(parts.face_contacts) == counts.left_slope + counts.right_slope + counts.level);
    RC_ASSERT(sum(parts.corner_contacts) == counts.apex);
  }
  RC_ASSERT(simulation.observed().size() == simulation.scene().observe.size());
}

void expectThatNothingGetsLost(Method method)
{
  int runs = 0;
  int stalls = 0;
  EXPECT_TRUE(rc::check(
      [&]
      {
        ++runs;
        SceneDefinition scene = test::drawnScene();
        scene.accuracy.method = method;
        scene.accuracy.step = *rc::gen::element(1e-4, 0.001, 0.02);
        Simulation simulation(scene);
        simulation.setSlewRates({*rc::gen::element(0.05, 0.5), 20.0, 0.01});
        try
        {
          for (int k = 1; k <= 20; ++k)
          {
            simulation.advanceTo(0.05 * k);
            checkState(simulation);
            test::commandSomething(simulation);
          }
        }
        catch (const StallError&)
        {
          // A jam, for example a disk wedged between two faces, is reported.
          ++stalls;
        }
      }));
  EXPECT_LE(stalls, 3 + runs / 50) << "of " << runs << " runs";
}

TEST(RandomScenes, NothingLeaksOverlapsOrGetsLost)
{
  expectThatNothingGetsLost(Method::EVENTS);
}

TEST(RandomScenes, NothingGetsLostBySteps)
{
  expectThatNothingGetsLost(Method::STEPS);
}

}  // namespace
}  // namespace ratchet_sieve
