#include "ratchet_sieve/core/choke.h"

#include "ratchet_sieve/core/disks_of_scene.h"

namespace ratchet_sieve
{
namespace
{
/// By which the feed has raised the layer [largest diameters]. The layer of Fig. 8 is 3.1 of them thick.
constexpr double CHOKED_LAYER = 4.0;
}  // namespace

std::optional<Choke> chokeOf(const Simulation& simulation)
{
  const SceneDefinition& scene = simulation.scene();
  if (!scene.feed.any())
    return std::nullopt;
  Choke choke;
  choke.fed = -static_cast<double>(disksAtStart(scene));
  for (const SpeciesBins& bins : simulation.bins())
  {
    choke.left += static_cast<double>(bins.counted());
    choke.fed += static_cast<double>(bins.counted() + bins.on_base);
  }
  if (2.0 * choke.left >= choke.fed)
    return std::nullopt;
  choke.layers = feedGrowth(scene) * (choke.fed - choke.left) / feedRate(scene) / largestDiameter(scene);
  return choke.layers > CHOKED_LAYER ? std::optional(choke) : std::nullopt;
}

}  // namespace ratchet_sieve
