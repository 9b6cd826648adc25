#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
/// The fastest that a node lets itself be told, in rad/s; a feeder does 0.1.
constexpr double FASTEST = 15.0;

/// Thrown to and fro between +-0.5 rad, and looked at on the way.
void expectThatNothingPasses(SceneDefinition scene, double slew_rate)
{
  Simulation simulation(scene);
  simulation.setSlewRates({slew_rate, 10.0, 0.002});
  double target = 0.5;
  double time = 0.0;
  for (int turn = 0; turn < 30; ++turn)
  {
    simulation.command(Quantity::INCLINATION, target);
    target = -target;
    // Sometimes it gets there, sometimes it is turned back on the way.
    for (int look = 0; look < 10 + 3 * (turn % 4); ++look)
    {
      simulation.advanceTo(time += 0.005);
      ASSERT_EQ(simulation.auditOverlaps(), 0u) << "at " << time;
    }
  }
  EXPECT_GT(simulation.collisions().total(), 50u);
  // Rounding: a 1e-11 part of the smallest radius.
  EXPECT_LT(simulation.maxOverlap(), 1e-11 * 0.001);
}

TEST(TurningBase, PassesThroughNoDiskAtAnySlewRate)
{
  for (const double slew_rate : {0.1, 1.0, FASTEST})
    for (const Boundary boundary : {Boundary::PERIODIC, Boundary::OPEN})
      for (const bool pairs : {true, false})
      {
        SceneDefinition scene = pairs ? test::openMixture(15) : test::singleParticles(30);
        scene.base.teeth = 8;
        scene.boundary = boundary;
        SCOPED_TRACE(std::to_string(slew_rate) + (pairs ? " pairs" : " singles") +
                     (boundary == Boundary::OPEN ? " open" : " periodic"));
        expectThatNothingPasses(scene, slew_rate);
      }
}
}  // namespace
}  // namespace ratchet_sieve
