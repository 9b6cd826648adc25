#include "ratchet_sieve/recording/frames.h"

#include "ratchet_sieve/recording/version.h"
#include "ratchet_sieve/scene/canonical_scene.h"

namespace ratchet_sieve
{
namespace
{

std::vector<std::string> speciesNames(const SceneDefinition& scene)
{
  std::vector<std::string> names;
  for (const SpeciesDefinition& species : scene.species)
    names.push_back(species.name);
  return names;
}

}  // namespace

std::vector<double> granularTemperatures(const std::vector<DiskState>& disks,
                                         const std::vector<double>& masses)
{
  struct Velocities
  {
    double count = 0.0, mean_x = 0.0, mean_y = 0.0, squares = 0.0;
  };
  // Welford's update keeps the variance of nearly equal velocities from drowning in their mean.
  std::vector<Velocities> sums(masses.size());
  for (const DiskState& disk : disks)
  {
    Velocities& sum = sums[disk.species];
    sum.count += 1.0;
    const double dx = disk.vx - sum.mean_x;
    const double dy = disk.vy - sum.mean_y;
    sum.mean_x += dx / sum.count;
    sum.mean_y += dy / sum.count;
    sum.squares += dx * (disk.vx - sum.mean_x) + dy * (disk.vy - sum.mean_y);
  }
  std::vector<double> temperatures(masses.size(), 0.0);
  for (std::size_t i = 0; i < masses.size(); ++i)
    if (sums[i].count > 0.0)
      temperatures[i] = 0.5 * masses[i] * sums[i].squares / sums[i].count;
  return temperatures;
}

SceneFrame makeSceneFrame(const Simulation& simulation)
{
  const SceneDefinition& scene = simulation.scene();
  return {simulation.time(), simulation.startTime(), canonicalYaml(scene), sceneHash(scene), scene.seed,
          version()};
}

ParticleFrame makeParticleFrame(const Simulation& simulation)
{
  return {simulation.time(), simulation.disks()};
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

StatisticsFrame makeStatisticsFrame(const Simulation& simulation, const std::vector<DiskState>& disks,
                                    const StatisticsFrame* previous, double wall_seconds)
{
  StatisticsFrame frame;
  frame.time = simulation.time();
  frame.species = speciesNames(simulation.scene());
  frame.means = simulation.means();
  std::vector<double> masses;
  for (const SpeciesDefinition& species : simulation.scene().species)
    masses.push_back(species.mass);
  frame.granular_temperature = granularTemperatures(disks, masses);
  frame.collisions = simulation.collisions();
  frame.events = simulation.events();
  frame.max_overlap = simulation.maxOverlap();
  if (previous != nullptr && frame.time > previous->time)
  {
    const double elapsed = frame.time - previous->time;
    frame.collision_rate =
        static_cast<double>(frame.collisions.total() - previous->collisions.total()) / elapsed;
    if (wall_seconds > 0.0)
      frame.real_time_factor = elapsed / wall_seconds;
  }
  return frame;
}

}  // namespace ratchet_sieve
