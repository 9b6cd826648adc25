#include "ratchet_sieve/analysis/run_analysis.h"

#include <algorithm>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "frame_rules.h"
#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{
namespace
{

/// Distributions are taken at the ends of this many equal parts of the duration.
constexpr int DISTRIBUTION_TIMES = 4;

std::vector<double> distributionTimes(double duration)
{
  std::vector<double> times;
  for (int k = 1; k <= DISTRIBUTION_TIMES; ++k)
    times.push_back(duration * k / DISTRIBUTION_TIMES);
  return times;
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

/// The accumulated data of one run.
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

  void take(const BaseFrame& frame) { base.take(frame); }
  void take(const ParticleFrame& frame);
  void take(const BinFrame& frame);
  void take(const StatisticsFrame& frame);
  void take(const ObservedFrame& frame) { observed = frame.observed; }

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
  std::vector<Observed> observed;
  std::vector<TemperatureSum> temperatures;  ///< per species, over frames
};

void RunAnalysis::Run::take(const ParticleFrame& frame)
{
  ++particle_frames;
  tracker.take(frame);
  distributions.take(frame);
  drift.take(driftOf(frame, scene.species.size()));
}

void RunAnalysis::Run::take(const BinFrame& frame)
{
  // s, Q and P are computed from the counts, not copied from the frame, so that the analysis is independent.
  BinFrame counted = frame;
  addRatios(counted);
  if (bins.empty() || !sameBits(bins.back().bins, counted.bins))
    bins.push_back(counted);
  last_bins = std::move(counted);
}

void RunAnalysis::Run::take(const StatisticsFrame& frame)
{
  statistics.take(frame);
  if (frame.window_start < scene.settle)
    return;
  for (std::size_t i = 0; i < temperatures.size(); ++i)
    if (frame.species[i].granular_temperature)
      temperatures[i].add(*frame.species[i].granular_temperature);
}

RunAnalysis::RunAnalysis() = default;
RunAnalysis::~RunAnalysis() = default;

RunAnalysis::Run& RunAnalysis::runAt(const AnyFrame& frame)
{
  if (!run_)
    throw AnalysisError(fmt::format("a frame of {} at {} s comes before any scene",
                                    describe(frame.kind()).name, frame.time()));
  run_->end = std::max(run_->end, frame.time());
  return *run_;
}

void RunAnalysis::take(const AnyFrame& any)
{
  any.visit(
      [&](const auto& frame)
      {
        using Frame = std::decay_t<decltype(frame)>;
        if constexpr (std::is_same_v<Frame, SceneFrame>)
          run_ = std::make_unique<Run>(frame, sceneFromText(frame.yaml, "recorded scene").definition);
        else if constexpr (IS_TAKEN_AT_A_RATE<Frame>)
        {
          Run& run = runAt(any);
          requireSound(frame, run.scene);
          run.take(frame);
        }
      });
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
  result.observed = run.observed;
  for (const TemperatureSum& temperature : run.temperatures)
    result.granular_temperatures.push_back(temperature.mean());
  return result;
}

std::vector<std::string> RunResult::missing() const
{
  std::vector<std::string> kinds;
  const auto require = [&](FrameKind kind, bool recorded)
  {
    if (!recorded)
      kinds.emplace_back(describe(kind).name);
  };
  require(FrameKind::PARTICLES, particle_frames > 0);
  require(FrameKind::BINS, !bins.empty());
  require(FrameKind::BASE, !base.empty());
  require(FrameKind::STATISTICS, !statistics.empty());
  require(FrameKind::OBSERVED, !observed.empty() || !isObserved(scene));
  return kinds;
}

std::optional<double> RunResult::shortToLong() const
{
  return statistics.empty() ? std::nullopt
                            : statistics.back().collisions.shortToLong(scene.base.slopeAsymmetry());
}

}  // namespace ratchet_sieve
