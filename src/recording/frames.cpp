#include "ratchet_sieve/recording/frames.h"

#include <algorithm>
#include <utility>

#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"

namespace ratchet_sieve
{
namespace
{
/// The size classes of each species that has sizes, as an observable.
Observed observedSizeClasses(const Simulation& simulation)
{
  Observed observed{SIZE_CLASSES, {}};
  const std::vector<SizeClass>& classes = simulation.sizeClasses();
  const std::vector<SpeciesMeans> means = simulation.sizeClassMeans();
  for (std::size_t k = 0; k < classes.size();)
  {
    const std::size_t species = classes[k].species;
    ObservedRow row{"", simulation.scene().species[species].name, {}, {}};
    row.table = {{"radius_from", "m", {}},
                 {"radius_to", "m", {}},
                 {"left", "", {}},
                 {"right", "", {}},
                 {"on_base", "", {}},
                 {"mean_vx", "m/s", {}},
                 {"mean_vx_stderr", "m/s", {}}};
    std::vector<SpeciesBins> all;
    for (; k < classes.size() && classes[k].species == species; ++k)
    {
      const SpeciesBins& bins = all.emplace_back(simulation.sizeClassBins()[k]);
      addLine(row.table, {classes[k].smallest, classes[k].largest, static_cast<double>(bins.left),
                          static_cast<double>(bins.right), static_cast<double>(bins.on_base),
                          means[k].mean_vx, means[k].mean_vx_stderr});
    }
    row.numbers = {{"size_quality", "", bestSeparation(all).quality()}};
    observed.rows.push_back(std::move(row));
  }
  return observed;
}
}  // namespace

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

void addRatios(BinFrame& frame)
{
  const PairSeparation best = bestSeparation(frame.bins);
  frame.separation = best.separation;
  frame.quality = best.quality();
  frame.processed = processedRatio(frame.bins);
}

BinFrame makeBinFrame(const Simulation& simulation)
{
  BinFrame frame;
  frame.time = simulation.time();
  frame.species = speciesNames(simulation.scene());
  frame.bins = simulation.bins();
  addRatios(frame);
  return frame;
}

BaseFrame makeBaseFrame(const Simulation& simulation)
{
  return {simulation.time(), simulation.base()};
}

ObservedFrame makeObservedFrame(const Simulation& simulation)
{
  ObservedFrame frame{simulation.time(), simulation.observed()};
  if (!simulation.sizeClasses().empty())
    frame.observed.push_back(observedSizeClasses(simulation));
  return frame;
}

bool isObserved(const SceneDefinition& scene)
{
  return !scene.observe.empty() || std::any_of(scene.species.begin(), scene.species.end(),
                                               [](const SpeciesDefinition& s) { return s.size.vary(); });
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
