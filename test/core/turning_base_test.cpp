#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace ratchet_sieve
{
namespace
{
/// The largest slew rate that a node accepts, in rad/s; a feeder has 0.1.
constexpr double FASTEST = 15.0;

/// A walled base that is tilted to and fro for 6.4 s, at its largest slew rate.
struct Tilting
{
  double width;      ///< [m]
  double slew_rate;  ///< [rad/s]
  double swing;      ///< [rad]
  bool pairs = true;

  double highest = 0.0;  ///< largest height of a disk over the base [m]
  std::uint64_t over = 0;

  Simulation run()
  {
    SceneDefinition scene = test::mixture(10);
    scene.base.teeth = static_cast<int>(std::lround(width / scene.base.tooth_width));
    scene.boundary = Boundary::WALLED;
    scene.contact.pair_collisions = pairs;
    Simulation simulation(scene);
    simulation.setSlewRates({slew_rate, 10.0, 0.002});
    double target = swing;
    simulation.command(Quantity::INCLINATION, target);
    for (int k = 1; k <= 320; ++k)
    {
      simulation.advanceTo(0.02 * k);
      const DriveState base = simulation.base();
      for (const DiskState& disk : simulation.disks())
        highest = std::max(highest, std::cos(base.inclination) * (disk.y - base.displacement) -
                                        std::sin(base.inclination) * disk.x);
      EXPECT_EQ(simulation.auditOverlaps(), 0u);
      if (base.inclination == target)
        simulation.command(Quantity::INCLINATION, target = -target);
    }
    for (const SpeciesBins& bins : simulation.bins())
      over += bins.counted();
    return simulation;
  }
};

/// With infinitely high walls, these runs threw disks to 50 km and did not end.
TEST(TurningBase, ThrowsNoDiskFarBeyondItsWalls)
{
  for (Tilting tilting : {Tilting{0.2, 3.0, 1.2}, Tilting{0.2, 5.0, 1.2}, Tilting{2.0, 3.0, 0.5},
                          Tilting{8.0, 1.0, 0.5}, Tilting{2.0, FASTEST, 0.5}, Tilting{2.0, 5.0, 0.5, false}})
  {
    SCOPED_TRACE(std::to_string(tilting.width) + " m at " + std::to_string(tilting.slew_rate) + " rad/s");
    const Simulation simulation = tilting.run();
    EXPECT_LT(tilting.highest, 2.0 * wallHeight(simulation.scene()));
    EXPECT_LT(simulation.maxOverlap(), 1e-9 * 0.001);
    EXPECT_LT(simulation.events(), 100000u);
    EXPECT_EQ(tilting.over + simulation.activeDisks(), 20u);
  }
}

TEST(TurningBase, KeepsItsDisksAtACalmTurnRate)
{
  for (const double width : {0.2, 1.0, 4.0, 8.0})
    for (const double swing : {0.5, 1.2})
    {
      SceneDefinition scene = test::mixture(0);
      scene.base.tooth_width = width / scene.base.teeth;
      Tilting tilting{width, 0.999 * calmTurnRate(scene), swing};
      const Simulation simulation = tilting.run();
      EXPECT_EQ(tilting.over, 0u) << width << " m, " << swing << " rad";
      EXPECT_LT(tilting.highest, wallHeight(simulation.scene())) << width << " m, " << swing << " rad";
    }
}
}  // namespace
}  // namespace ratchet_sieve
