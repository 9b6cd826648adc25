#include "ratchet_sieve/analysis/run_analysis.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "frame_rules.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// Displacements are distributed at the ends of this many equal parts of the duration.
constexpr int DISTRIBUTION_TIMES = 4;

std::vector<double> distributionTimes(double duration)
{
  std::vector<double> times;
  for (int k = 1; k <= DISTRIBUTION_TIMES; ++k)
    times.push_back(duration * k / DISTRIBUTION_TIMES);
  return times;
}

bool sameBins(const BinFrame& a, const BinFrame& b)
{
  return std::equal(a.bins.begin(), a.bins.end(), b.bins.begin(), b.bins.end(),
                    [](const SpeciesBins& x, const SpeciesBins& y)
                    { return x.left == y.left && x.right == y.right && x.on_base == y.on_base; });
}

Drift driftOf(const ParticleFrame& frame, std::size_t species_count)
{
  Drift drift{frame.time, std::vector<std::size_t>(species_count), {}};
  std::vector<double> sums(species_count);
  for (const DiskState& disk : frame.disks)
  {
    ++drift.disks[disk.species];
    sums[disk.species] += disk.displacement;
  }
  for (std::size_t i = 0; i < species_count; ++i)
    drift.displacements.push_back(drift.disks[i] > 0
                                      ? std::optional<double>(sums[i] / static_cast<double>(drift.disks[i]))
                                      : std::nullopt);
  return drift;
}

}  // namespace

/// All that is kept of one run.
struct RunAnalysis::Run
{
  Run(const SceneFrame& frame, SceneDefinition definition)
      : scene_frame(frame),
        scene(std::move(definition)),
        start(frame.time),
        end(frame.time),
        tracker(scene.species.size(), scene.settle, !scene.contact.pair_collisions),
        distributions(scene.species.size(), distributionTimes(scene.duration)),
        temperatures(scene.species.size())
  {
  }

  SceneFrame scene_frame;
  SceneDefinition scene;
  double start;
  double end;
  std::size_t particle_frames = 0;
  DisplacementTracker tracker;
  DisplacementDistributions distributions;
  std::vector<BinFrame> bins;
  std::optional<BinFrame> last_bins;
  ThinnedSeries<Drift> drift;
  ThinnedSeries<BaseFrame> base;
  ThinnedSeries<StatisticsFrame> statistics;
  std::vector<TemperatureSum> temperatures;  ///< per species, over frames
};

RunAnalysis::RunAnalysis() = default;
RunAnalysis::~RunAnalysis() = default;

RunAnalysis::Run& RunAnalysis::run(const char* kind, double time)
{
  if (!run_)
    throw AnalysisError(fmt::format("a {} frame at {} s comes before any scene", kind, time));
  run_->end = std::max(run_->end, time);
  return *run_;
}

void RunAnalysis::take(const SceneFrame& frame)
{
  run_ = std::make_unique<Run>(frame, sceneFromText(frame.yaml, "recorded scene").definition);
}

void RunAnalysis::take(const ParticleFrame& frame)
{
  Run& run = this->run("particle", frame.time);
  requireSound(frame, run.scene);
  ++run.particle_frames;
  run.tracker.take(frame);
  run.distributions.take(frame);
  run.drift.take(driftOf(frame, run.scene.species.size()));
}

void RunAnalysis::take(const BinFrame& frame)
{
  Run& run = this->run("bin", frame.time);
  requireSound(frame, run.scene);
  // Q and P from the counts, not as the frame says: the analysis is to stand on its own.
  BinFrame counted = frame;
  counted.quality = bestQuality(frame.bins);
  counted.processed = processedRatio(frame.bins);
  if (run.bins.empty() || !sameBins(run.bins.back(), counted))
    run.bins.push_back(counted);
  run.last_bins = std::move(counted);
}

void RunAnalysis::take(const BaseFrame& frame)
{
  Run& run = this->run("base", frame.time);
  requireSound(frame, run.scene);
  run.base.take(frame);
}

void RunAnalysis::take(const StatisticsFrame& frame)
{
  Run& run = this->run("statistics", frame.time);
  requireSound(frame, run.scene);
  run.statistics.take(frame);
  if (frame.window_start < run.scene.settle)
    return;
  for (std::size_t i = 0; i < run.temperatures.size(); ++i)
    if (frame.granular_temperature[i])
      run.temperatures[i].add(*frame.granular_temperature[i]);
}

RunResult RunAnalysis::result() const
{
  if (!run_)
    throw AnalysisError("no scene was recorded");
  const Run& run = *run_;
  RunResult result;
  result.scene_frame = run.scene_frame;
  result.scene = run.scene;
  result.start = run.start;
  result.end = run.end;
  result.particle_frames = run.particle_frames;
  for (const SpeciesDefinition& species : run.scene.species)
    result.species.push_back(species.name);
  result.velocities = run.tracker.velocities();
  result.displacement_distributions = run.distributions.distributions();
  result.bins = run.bins;
  if (run.last_bins && run.last_bins->time > run.bins.back().time)
    result.bins.push_back(*run.last_bins);
  result.drift = run.drift.samples();
  result.base = run.base.samples();
  result.statistics = run.statistics.samples();
  for (const TemperatureSum& temperature : run.temperatures)
    result.granular_temperatures.push_back(temperature.mean());
  return result;
}

std::vector<std::string> RunResult::missing() const
{
  std::vector<std::string> kinds;
  if (particle_frames == 0)
    kinds.emplace_back("particles");
  if (bins.empty())
    kinds.emplace_back("bins");
  if (base.empty())
    kinds.emplace_back("base");
  if (statistics.empty())
    kinds.emplace_back("statistics");
  return kinds;
}

std::optional<double> RunResult::shortToLong() const
{
  return statistics.empty() ? std::nullopt : statistics.back().collisions.shortToLong(scene.base.asymmetry);
}

}  // namespace ratchet_sieve
