#include "ratchet_sieve/recording/run_warnings.h"

#include <fmt/format.h>

#include "ratchet_sieve/core/choke.h"
#include "ratchet_sieve/core/disks_of_scene.h"
#include "ratchet_sieve/core/drive_of_scene.h"

namespace ratchet_sieve
{
std::string chokeText(const Simulation& simulation)
{
  const std::optional<Choke> choke = chokeOf(simulation);
  if (!choke)
    return {};
  std::string text = fmt::format(
      "the base is choked: of {:g} disks fed by {:.4g} s {:g} have left, and the layer has risen by {:.3g} "
      "of the largest diameters",
      choke->fed, simulation.time(), choke->left, choke->layers);
  const SceneDefinition& scene = simulation.scene();
  if (scene.gravity > 0.0)
    text += fmt::format("; the drive's peak acceleration is {:.3g} g", peakLift(scene.base) / scene.gravity);
  return text;
}

std::string energyText(const Simulation& simulation)
{
  const std::optional<LargeEnergy>& first = simulation.implausibleEnergy();
  if (!first)
    return {};
  return fmt::format(
      "implausibly large energy: at {:.6g} s disk {} had {:.6g} J at a height of {:.6g} m, {:.6g} times its "
      "energy after the highest fall and an elastic bounce off the base; largest so far: {:.6g} times",
      first->time, first->disk, first->energy, first->height, first->scales, simulation.largestEnergy());
}

std::uint64_t disksOverWalls(const Simulation& simulation)
{
  std::uint64_t count = 0;
  if (simulation.scene().boundary == Boundary::WALLED)
    for (const SpeciesBins& bins : simulation.bins())
      count += bins.counted();
  return count;
}

std::string overWallsText(const Simulation& simulation)
{
  const std::uint64_t count = disksOverWalls(simulation);
  if (count == 0)
    return {};
  std::uint64_t left = 0;
  for (const SpeciesBins& bins : simulation.bins())
    left += bins.left;
  return fmt::format(
      "{} of the disks went over the walls, which are {:.3g} m high: {} to the left, {} to the right; "
      "base.wall_height makes them higher",
      count, wallHeight(simulation.scene()), left, count - left);
}

std::string fastTurnText(const SceneDefinition& scene, double slew_rate)
{
  const double calm = calmTurnRate(scene);
  if (scene.boundary != Boundary::WALLED || slew_rate <= calm)
    return {};
  return fmt::format(
      "limits/inclination/slew_rate = {:g} rad/s: a walled base {:.3g} m wide that turns faster "
      "than {:.3g} rad/s may throw its disks over the walls, {:.3g} m high",
      slew_rate, scene.base.width(), calm, wallHeight(scene));
}

}  // namespace ratchet_sieve
