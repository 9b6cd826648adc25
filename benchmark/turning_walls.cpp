// How a walled base that is tilted to and fro keeps its disks: a table over its width and the rate of the
// turn, for docs/stability.md. Exit status 1 where disks overlap, or go over the walls of a base that turns
// no faster than it may.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "ratchet_sieve/core/layer.h"
#include "ratchet_sieve/core/simulation.h"
#include "scenes.h"

namespace
{
using namespace ratchet_sieve;

constexpr double DURATION = 10.0;  // [s]
constexpr double LOOK = 0.02;      // [s]
constexpr int DISKS = 20;
constexpr int SEEDS = 4;
constexpr double LARGEST_OVERLAP = 1e-9;  // of the smallest radius

/// The worst of several runs.
struct Found
{
  std::uint64_t over = 0;  // the walls
  double highest = 0.0;    // place of a disk over the base, in widths of it
  double overlap = 0.0;    // in radii of the smallest disk
};

void run(const SceneDefinition& scene, double slew_rate, double swing, Found& found)
{
  Simulation simulation(scene);
  simulation.setSlewRates({slew_rate, 10.0, 0.002});
  double target = swing;
  simulation.command(Quantity::INCLINATION, target);
  for (int k = 1; k * LOOK <= DURATION; ++k)
  {
    simulation.advanceTo(k * LOOK);
    simulation.auditOverlaps();
    const DriveState base = simulation.base();
    for (const DiskState& disk : simulation.disks())
    {
      const double n =
          std::cos(base.inclination) * (disk.y - base.displacement) - std::sin(base.inclination) * disk.x;
      found.highest = std::max(found.highest, n / scene.base.width());
    }
    if (base.inclination == target)
      simulation.command(Quantity::INCLINATION, target = -target);
  }
  for (const SpeciesBins& bins : simulation.bins())
    found.over += bins.counted();
  found.overlap = std::max(found.overlap, simulation.maxOverlap() / scene.species[0].radius);
}

/// Fills one cell. @return whether it came out as it has to
bool cell(double width, double slew_rate, double& largest_overlap)
{
  SceneDefinition scene = test::mixture(DISKS / 2);
  scene.boundary = Boundary::WALLED;
  scene.base.teeth = static_cast<int>(std::lround(width / scene.base.tooth_width));
  Found found;
  for (const double swing : {0.5, 1.2})
    for (int seed = 1; seed <= SEEDS; ++seed)
    {
      scene.seed = static_cast<std::uint64_t>(seed);
      run(scene, slew_rate, swing, found);
    }
  const bool calm = slew_rate <= calmTurnRate(scene);
  std::printf(" %llu, %.2g%s |", static_cast<unsigned long long>(found.over), found.highest,
              calm ? "" : " ⚠");
  largest_overlap = std::max(largest_overlap, found.overlap);
  return found.over == 0 || !calm;
}
}  // namespace

int main()
{
  constexpr double SLEW_RATES[] = {0.1, 0.3, 1.0, 1.5, 2.0, 3.0, 5.0, 15.0};  // [rad/s]
  std::printf("| W [m] |");
  for (const double slew_rate : SLEW_RATES)
    std::printf(" %g |", slew_rate);
  std::printf("\n|---|---|---|---|---|---|---|---|---|\n");
  bool good = true;
  double overlap = 0.0;
  for (const double width : {0.2, 0.4, 1.0, 2.0, 4.0, 8.0})
  {
    std::printf("| %g |", width);
    for (const double slew_rate : SLEW_RATES)
      good = cell(width, slew_rate, overlap) && good;
    std::printf("\n");
    std::fflush(stdout);
  }
  std::printf("\nOf %d disks each; largest overlap %.1e r.\n", 2 * SEEDS * DISKS, overlap);
  return good && overlap < LARGEST_OVERLAP ? 0 : 1;
}
