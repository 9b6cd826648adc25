#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ratchet_sieve/analysis/displacements.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Frames that do not fit together: no scene before them, or species that are not in the scene.
struct AnalysisError : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

/// The mean displacements, since entry, of the disks in the machine at one time.
struct Drift
{
  double time = 0.0;                                 ///< [s]
  std::vector<std::size_t> disks;                    ///< per species
  std::vector<std::optional<double>> displacements;  ///< per species, mean [m]; nothing without disks
};

/// The result of a run, computed from its frames alone. Of a long series every 2^k-th sample is
/// kept, and the last; of the bins every change, if wanted.
struct RunResult
{
  SceneFrame scene_frame;
  SceneDefinition scene;
  double start = 0.0;  ///< of the scene's frame [s]
  std::optional<double>
      first_frame;   ///< time of the first other frame: later if the recording began late [s]
  double end = 0.0;  ///< of the last frame [s]
  std::size_t particle_frames = 0;

  std::vector<std::string> species;
  std::vector<DriftVelocity> velocities;                     ///< per species, after `settle`
  std::vector<std::optional<double>> granular_temperatures;  ///< per species, mean after `settle` [J]
  std::vector<DisplacementDistribution> displacement_distributions;
  std::vector<Drift> drift;

  std::vector<BinFrame> bins;  ///< first, changes, last
  std::vector<BaseFrame> base;
  std::vector<StatisticsFrame> statistics;
  std::vector<Observed> observed;  ///< of the last frame, which is of the whole run

  /// Contacts with the shorter slope over contacts with the longer one, since the start.
  std::optional<double> shortToLong() const;
  /// The kinds of frames that were not recorded. Quantities computed from them are undefined, not zero.
  std::vector<std::string> missing() const;
  const BinFrame* lastBins() const { return bins.empty() ? nullptr : &bins.back(); }
  const StatisticsFrame* lastStatistics() const { return statistics.empty() ? nullptr : &statistics.back(); }
};

/// Analyses a run frame by frame: memory grows with the number of disks, not with the number of frames. A
/// scene frame begins a new analysis and discards the previous one.
class RunAnalysis : public FrameSink
{
public:
  /// @param every_change of the bins is kept; otherwise they are a long series as all others
  explicit RunAnalysis(bool every_change = true);
  ~RunAnalysis() override;

  /// @throws SceneError if a scene's YAML is invalid
  /// @throws AnalysisError for frames that do not fit the scene
  void take(const AnyFrame& frame) override;

  /// @throws AnalysisError if no scene was taken
  RunResult result() const;

private:
  struct Run;
  bool every_change_;
  std::unique_ptr<Run> run_;
};

}  // namespace ratchet_sieve
