#include "ratchet_sieve/analysis/run_analysis.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ratchet_sieve/recording/same_bits.h"
#include "ratchet_sieve/scene/scene_file.h"
#include "ratchet_sieve/scene/shown_text.h"

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

/// @throws AnalysisError if a frame of this kind has another number of species than the scene
template <typename Frame>
void requireSpecies(std::size_t count, const SceneDefinition& scene)
{
  if (count != scene.species.size())
    throw AnalysisError(fmt::format("a frame of {} with {} species does not fit the scene, which has {}",
                                    describe(kindOf<Frame>()).name, count, scene.species.size()));
}

/// @throws AnalysisError where the scene does not observe it, or the columns of a table differ in length: its
/// name becomes that of a file, and the columns the lines in it
void requireFits(const Observed& observed, const SceneDefinition& scene)
{
  const std::vector<std::string>& names = scene.observe;
  if (observed.name != SIZE_CLASSES && std::find(names.begin(), names.end(), observed.name) == names.end())
    throw AnalysisError(fmt::format("a frame of observed has {}, which the scene does not observe",
                                    shownText(observed.name)));
  for (const ObservedRow& row : observed.rows)
    for (const ObservedColumn& column : row.table)
      if (column.values.size() != row.table.front().values.size())
        throw AnalysisError(
            fmt::format("a frame of observed has columns of different lengths in {}", observed.name));
}

}  // namespace

/// A series of samples that keeps at most a fixed number of them: every 2^k-th, and the last.
template <typename Sample>
class ThinnedSeries
{
public:
  void add(Sample sample)
  {
    if (added_++ % stride_ != 0)
    {
      last_ = std::move(sample);
      return;
    }
    last_.reset();
    kept_.push_back(std::move(sample));
    if (kept_.size() > CAPACITY)
      thin();
  }

  /// In the order in which they came.
  std::vector<Sample> samples() const
  {
    std::vector<Sample> all = kept_;
    if (last_)
      all.push_back(*last_);
    return all;
  }

private:
  static constexpr std::size_t CAPACITY = 4096;  ///< even: see thin()

  /// Keeps every second sample. @pre the number of samples is odd, so that the last one stays
  void thin()
  {
    for (std::size_t i = 1; 2 * i < kept_.size(); ++i)
      kept_[i] = std::move(kept_[2 * i]);
    kept_.resize((kept_.size() + 1) / 2);
    stride_ *= 2;
  }

  std::size_t added_ = 0;
  std::size_t stride_ = 1;
  std::vector<Sample> kept_;
  std::optional<Sample> last_;  ///< if it is not among those kept
};

/// The accumulated data of one run: what its result has so far, and what the rest of it is computed from.
struct RunAnalysis::Run
{
  Run(const SceneFrame& frame, SceneDefinition definition, bool every_change_of_bins)
      : every_change(every_change_of_bins),
        tracker(definition.species.size(), definition.settle, !definition.contact.pair_collisions),
        distributions(definition.species.size(), distributionTimes(definition.duration)),
        temperatures(definition.species.size())
  {
    so_far.scene_frame = frame;
    so_far.start = so_far.end = frame.time;
    so_far.species = speciesNames(definition);
    so_far.scene = std::move(definition);
  }

  void add(const BaseFrame& frame) { base.add(frame); }
  void add(const ParticleFrame& frame);
  void add(const BinFrame& frame);
  void add(const StatisticsFrame& frame);
  void add(const ObservedFrame& frame);

  bool every_change;
  RunResult so_far;
  DisplacementTracker tracker;
  DisplacementDistributions distributions;
  std::optional<BinFrame> last_bins;
  ThinnedSeries<BinFrame> changes;  ///< of the bins, unless every one is kept
  ThinnedSeries<Drift> drift;
  ThinnedSeries<BaseFrame> base;
  ThinnedSeries<StatisticsFrame> statistics;
  std::vector<TemperatureSum> temperatures;  ///< per species, over frames
};

void RunAnalysis::Run::add(const ParticleFrame& frame)
{
  for (const DiskState& disk : frame.disks)
    if (disk.species >= so_far.species.size())
      throw AnalysisError(fmt::format("disk {} at {} s has species {}, and the scene {} of them", disk.id,
                                      frame.time, disk.species, so_far.species.size()));
  ++so_far.particle_frames;
  tracker.add(frame);
  distributions.add(frame);
  drift.add(driftOf(frame, so_far.species.size()));
}

void RunAnalysis::Run::add(const BinFrame& frame)
{
  requireSpecies<BinFrame>(frame.bins.size(), so_far.scene);
  // s, Q and P are computed from the counts, not copied from the frame, so that the analysis is independent.
  BinFrame counted = frame;
  addRatios(counted);
  if (!last_bins || !sameBits(last_bins->bins, counted.bins))
  {
    if (every_change)
      so_far.bins.push_back(counted);
    else
      changes.add(counted);
  }
  last_bins = std::move(counted);
}

void RunAnalysis::Run::add(const StatisticsFrame& frame)
{
  requireSpecies<StatisticsFrame>(frame.species.size(), so_far.scene);
  statistics.add(frame);
  if (frame.window_start < so_far.scene.settle)
    return;
  for (std::size_t i = 0; i < temperatures.size(); ++i)
    if (frame.species[i].granular_temperature)
      temperatures[i].add(*frame.species[i].granular_temperature);
}

void RunAnalysis::Run::add(const ObservedFrame& frame)
{
  for (const Observed& observed : frame.observed)
    requireFits(observed, so_far.scene);
  so_far.observed = frame.observed;
}

RunAnalysis::RunAnalysis(bool every_change) : every_change_(every_change) {}
RunAnalysis::~RunAnalysis() = default;

void RunAnalysis::take(const AnyFrame& any)
{
  any.visit(
      [&](const auto& frame)
      {
        using Frame = std::decay_t<decltype(frame)>;
        if constexpr (std::is_same_v<Frame, SceneFrame>)
          run_ = std::make_unique<Run>(frame, sceneFromText(frame.yaml, "recorded scene").definition,
                                       every_change_);
        else if constexpr (IS_TAKEN_AT_A_RATE<Frame>)
        {
          if (!run_)
            throw AnalysisError(fmt::format("a frame of {} at {} s comes before any scene",
                                            describe(kindOf<Frame>()).name, frame.time));
          run_->so_far.end = std::max(run_->so_far.end, frame.time);
          if (!run_->so_far.first_frame)
            run_->so_far.first_frame = frame.time;
          run_->add(frame);
        }
      });
}

RunResult RunAnalysis::result() const
{
  if (!run_)
    throw AnalysisError("no scene was recorded");
  const Run& run = *run_;
  RunResult result = run.so_far;
  result.velocities = run.tracker.velocities();
  result.displacement_distributions = run.distributions.distributions();
  if (!run.every_change)
    result.bins = run.changes.samples();
  if (run.last_bins && run.last_bins->time > result.bins.back().time)
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
