#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ratchet_sieve/ros/fan_out.h"
#include "ratchet_sieve/ros/live_run.h"
#include "ratchet_sieve/ros/node_parameters.h"
#include "ratchet_sieve/ros/recorder.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// How a request went.
struct Outcome
{
  bool success = true;
  std::string message;  ///< on failure: why; else what is to be said of it, if anything
};

/// A run under command: paused, stepped, reset, poured on, driven by setpoints. Knows frames and
/// sinks, but neither topics nor wall time; LiveRun advances, this decides.
class RunControl
{
public:
  /// Advances the run towards a time by a stride, by advanceTo(); false where the step is to be given up.
  using Stride = std::function<bool(double time)>;

  /// @param scene YAML of the scene, kept for resets; @param source named in errors
  /// @param recorder takes frames and setpoints; outlives this
  /// @param pour_observer of each pour that begins a run; see Simulation
  /// @throws SceneError, std::invalid_argument where the disks of the scene overlap
  RunControl(const YAML::Node& scene, const std::string& source, const NodeParameters& parameters,
             Recorder& recorder, PourObserver pour_observer = {});

  /// Another sink for the frames; outlives this.
  void addSink(FrameSink& sink) { sinks_.add(sink); }

  /// Hands the first frames to the sinks.
  void begin();

  /// Hands the last frames to the sinks and closes the recording.
  void end();

  const LiveRun& run() const { return *run_; }

  /// Of the scene that runs: see Scene.
  const std::vector<std::string>& sceneWarnings() const { return scene_warnings_; }

  /// One line where the run's base may turn too fast for its walls; or else empty. See fastTurnText().
  std::string turnWarning() const;
  bool paused() const { return paused_; }
  void pause();
  void unpause();

  /// Advances to a time, but no further than to the next frame or the end.
  void advanceTo(double time) { run_->advanceTo(time, sinks_); }

  /// Advances by `duration` [s] or to the end, in strides. Where the end comes first, that is no failure, and
  /// said.
  Outcome step(double duration, const Stride& stride);

  /// Takes setpoints, all or none, and steps.
  /// @param setpoints names and values
  Outcome lockStep(const std::vector<std::pair<std::string, double>>& setpoints, double duration,
                   const Stride& stride);

  /// Begins anew, at time 0 or at the present time. @param seed 0: the scene's own
  Outcome reset(std::uint64_t seed, const std::vector<std::string>& overrides, bool keep_time);

  /// Pours the disks anew, over a base that goes on as it moves; time goes on, to the end, or from there for
  /// another duration. Fails where the base now stands in disks of `initial`; the run then goes on as it was.
  Outcome resetWorld();

  Outcome pour(const std::string& species, std::size_t count);

  /// What the base is told to go to.
  double commanded(Quantity quantity) const;

  /// Commands the base at the present time; a value that is refused changes nothing.
  Outcome command(const Setpoint& setpoint, double value);

private:
  std::optional<std::string> whyNoStep(double duration) const;
  Outcome advance(double duration, const Stride& stride);
  Scene readScene(std::uint64_t seed, const std::vector<std::string>& overrides) const;
  void announce(const Scene& scene) const;
  std::unique_ptr<LiveRun> makeRun(const SceneDefinition& scene, std::vector<CommandFrame> opening,
                                   double start_time, double end_time) const;
  void begin(std::unique_ptr<LiveRun> run);

  /// Hands a frame to the sinks and the recorder, though none is due.
  void show(const AnyFrame& frame);

  YAML::Node scene_;
  std::string source_;
  NodeParameters parameters_;
  Recorder& recorder_;
  PourObserver pour_observer_;
  FanOut sinks_;
  std::vector<std::string> scene_warnings_;
  std::unique_ptr<LiveRun> run_;
  bool paused_;
};

}  // namespace ratchet_sieve
