#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

#include "findings.h"
#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/core/sizes.h"
#include "ratchet_sieve/scene/canonical_scene.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// A legal scene is written in a form that reads back the same.
void requireCanonical(const SceneDefinition& scene)
{
  const std::string yaml = canonicalYaml(scene);
  try
  {
    const SceneDefinition again = sceneFromText(yaml, "canonical").definition;
    if (canonicalYaml(again) != yaml || sceneHash(again) != sceneHash(scene))
      finding("reads back as another scene", yaml);
  }
  catch (const SceneError& error)
  {
    finding(error.what(), yaml);
  }
}

/// Whether a short run is cheap: few disks, and no motion so fast that it needs very small steps.
bool isTame(const SceneDefinition& scene)
{
  std::size_t disks = scene.initial.size();
  for (const SpeciesDefinition& species : scene.species)
  {
    const Sizes sizes(species);
    if (sizes.smallest() < 1e-4 || sizes.largest() > 1.0 || species.count > 10)
      return false;
    disks += static_cast<std::size_t>(species.count);
  }
  const auto slow = [](const InitialDisk& disk) {
    return std::max({disk.vx, -disk.vx, disk.vy, -disk.vy, disk.spin, -disk.spin}) < 100.0;
  };
  return disks <= 20 && std::all_of(scene.initial.begin(), scene.initial.end(), slow) &&
         scene.base.teeth <= 100 && scene.base.toothWidth() >= 1e-3 && scene.base.profile.size() <= 100 &&
         scene.base.amplitude <= 0.1 && scene.base.frequency <= 100.0 && scene.pour.speed <= 10.0 &&
         scene.feed.rate <= 100.0 && scene.gravity <= 100.0 && scene.accuracy.step >= 1e-5;
}

void runBriefly(const SceneDefinition& scene)
{
  constexpr double MOMENT = 0.02;  // [s]; a few contacts
  try
  {
    Simulation simulation(scene);
    simulation.advanceTo(std::min(MOMENT, scene.duration));
    simulation.disks();
    simulation.means();
    simulation.observed();
    simulation.sizeClassMeans();
    simulation.auditOverlaps();
  }
  catch (const std::invalid_argument& error)
  {
    requireOneLine(error.what());
  }
  catch (const StallError& error)
  {
    requireOneLine(error.what());
  }
}

void readScene(const std::string& text)
{
  try
  {
    const Scene scene = sceneFromText(text, "scene.yaml");
    for (const std::string& warning : scene.warnings)
      requireOneLine(warning);
    requireCanonical(scene.definition);
    if (isTame(scene.definition))
      runBriefly(scene.definition);
  }
  catch (const SceneError& error)
  {
    requireOneLine(error.what());
  }
}

}  // namespace
}  // namespace ratchet_sieve

/// The text of a scene file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
  ratchet_sieve::readScene(std::string(bytes, bytes + size));
  return 0;
}
