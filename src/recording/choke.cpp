#include "ratchet_sieve/recording/choke.h"

#include <fmt/format.h>

#include "ratchet_sieve/core/drive_of_scene.h"
#include "ratchet_sieve/core/layer.h"

namespace ratchet_sieve
{
namespace
{
/// By which the feed has raised the layer [largest diameters]. The layer of Fig. 8 is 3.1 of them thick.
constexpr double CHOKED_LAYER = 4.0;
}  // namespace

std::string chokeText(const Simulation& simulation)
{
  const SceneDefinition& scene = simulation.scene();
  if (scene.feed.rate <= 0.0)
    return {};
  double left = 0.0;
  double fed = -static_cast<double>(disksAtStart(scene));
  for (const SpeciesBins& bins : simulation.bins())
  {
    left += static_cast<double>(bins.counted());
    fed += static_cast<double>(bins.counted() + bins.on_base);
  }
  const double layers = feedGrowth(scene) * (fed - left) / scene.feed.rate / largestDiameter(scene);
  if (2.0 * left >= fed || layers <= CHOKED_LAYER)
    return {};
  std::string text = fmt::format(
      "the base is choked: of {:g} disks fed by {:.4g} s {:g} have left, and the layer has risen by {:.3g} "
      "of "
      "the largest diameters",
      fed, simulation.time(), left, layers);
  if (scene.gravity > 0.0)
    text += fmt::format("; the drive's peak acceleration is {:.3g} g", peakLift(scene.base) / scene.gravity);
  return text;
}

}  // namespace ratchet_sieve
