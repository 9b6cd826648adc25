#include <cmath>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/simulation.h"
#include "runs.h"
#include "scenes.h"

/// The claims of the paper (Granular segregation by an oscillating ratchet mechanism), and the results of
/// other programs for the same machine.
namespace ratchet_sieve
{
namespace
{

TEST(PaperClaims, Fig3DriftsRightWithThePapersRatioOfContacts)
{
  SceneDefinition scene = test::singleParticles(500);
  scene.settle = 5.0;
  Simulation simulation(scene);
  simulation.advanceTo(30.0);
  const auto means = simulation.means()[0];
  EXPECT_GT(*means.mean_vx, 20.0 * *means.mean_vx_stderr);
  // Section 3.1.1: "about 0.53"; with v_min = 0.05 m/s it is 0.52.
  EXPECT_NEAR(*simulation.collisions().shortToLong(0.3), 0.53, 0.02);
  EXPECT_EQ(simulation.auditOverlaps(), 0u);
}

TEST(PaperClaims, Fig3SpreadsWithTime)
{
  Simulation simulation(test::singleParticles(500));
  const auto spread = [&]
  {
    double sum = 0.0, squares = 0.0;
    for (const DiskState& disk : simulation.disks())
    {
      sum += disk.displacement;
      squares += disk.displacement * disk.displacement;
    }
    return squares / 500.0 - sum * sum / 500.0 / 500.0;
  };
  simulation.advanceTo(5.0);
  const double early = spread();
  simulation.advanceTo(20.0);
  EXPECT_GT(spread(), 2.5 * early);  // diffusion: four times, within the sampling error
}

TEST(PaperClaims, Fig4InclinationTurnsTheCurrent)
{
  SceneDefinition scene = test::singleParticles(500);
  scene.base.inclination = 0.209;
  Simulation simulation(scene);
  simulation.advanceTo(20.0);
  const auto means = simulation.means()[0];
  EXPECT_LT(*means.mean_vx, -5.0 * *means.mean_vx_stderr);
}

TEST(PaperClaims, Fig8MixtureAtRestAngleBothGoRightAndBIsFaster)
{
  // Four programs agree: A +16.5 to +18.7 mm/s, B +38.9 to +40.5 mm/s for 524 disks on 20 teeth.
  SceneDefinition scene = test::mixture(262);
  scene.settle = 2.0;
  Simulation simulation(scene);
  simulation.advanceTo(22.0);
  const auto means = simulation.means();
  EXPECT_NEAR(*means[0].mean_vx, 0.0176, 0.0025);
  EXPECT_NEAR(*means[1].mean_vx, 0.0395, 0.0030);
  test::expectNoOverlap(simulation);
}

/// In the paper, A moves to the right at this angle. Here it does not, for any way of measuring:
/// docs/paper.md.
TEST(PaperClaims, Fig8MixtureInclinedBothGoLeftAndBIsFaster)
{
  SceneDefinition scene = test::mixture(262);
  scene.base.inclination = 0.157;
  scene.settle = 2.0;
  Simulation simulation(scene);
  simulation.advanceTo(22.0);
  const auto means = simulation.means();
  for (const SpeciesMeans& species : means)
    EXPECT_LT(*species.mean_vx, -5.0 * *species.mean_vx_stderr);
  EXPECT_LT(*means[1].mean_vx - *means[0].mean_vx,
            -5.0 * std::hypot(*means[0].mean_vx_stderr, *means[1].mean_vx_stderr));
}

}  // namespace
}  // namespace ratchet_sieve
