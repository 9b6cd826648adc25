#include "ratchet_sieve/recording/frames.h"

#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"

namespace ratchet_sieve
{

std::vector<std::string> speciesNames(const SceneDefinition& scene)
{
  std::vector<std::string> names;
  for (const SpeciesDefinition& species : scene.species)
    names.push_back(species.name);
  return names;
}

SceneFrame makeSceneFrame(const Simulation& simulation)
{
  const SceneDefinition& scene = simulation.scene();
  return {simulation.time(), simulation.startTime(), canonicalYaml(scene), sceneHash(scene), scene.seed,
          version()};
}

ParticleFrame makeParticleFrame(const Simulation& simulation)
{
  ParticleFrame frame;
  makeParticleFrame(simulation, frame);
  return frame;
}

void makeParticleFrame(const Simulation& simulation, ParticleFrame& frame)
{
  frame.time = simulation.time();
  simulation.disks(frame.disks);
  if (simulation.sizeClasses().empty())
    for (DiskState& disk : frame.disks)
      disk.radius = 0.0;
}

BinFrame makeBinFrame(const Simulation& simulation)
{
  const std::vector<SpeciesBins> bins = simulation.bins();
  return {simulation.time(), speciesNames(simulation.scene()), bins, bestQuality(bins), processedRatio(bins)};
}

BaseFrame makeBaseFrame(const Simulation& simulation)
{
  return {simulation.time(), simulation.base()};
}

StatisticsFrame makeStatisticsFrame(const Simulation& simulation, const StatisticsWindow& window)
{
  StatisticsFrame frame;
  frame.time = simulation.time();
  frame.window_start = window.start();
  frame.window_end = window.end();
  const std::vector<SpeciesMeans> means = simulation.means();
  const std::vector<std::optional<double>>& temperatures = window.granularTemperatures();
  for (std::size_t i = 0; i < means.size(); ++i)
    frame.species.push_back({simulation.scene().species[i].name, means[i],
                             i < temperatures.size() ? temperatures[i] : std::nullopt});
  frame.collision_rates = window.collisionRates();
  frame.collisions = simulation.collisions();
  frame.faces = simulation.faceContacts();
  frame.events = simulation.events();
  frame.max_overlap = simulation.maxOverlap();
  return frame;
}

}  // namespace ratchet_sieve
