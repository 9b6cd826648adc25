#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ratchet_sieve/live/drives.h"
#include "ratchet_sieve/live/journal.h"
#include "ratchet_sieve/live/sensors.h"
#include "ratchet_sieve/live/setpoint.h"
#include "ratchet_sieve/recording/frame_sink.h"
#include "ratchet_sieve/recording/run.h"
#include "ratchet_sieve/scene/scene_file.h"

namespace ratchet_sieve
{

/// The settings of a run in a node. The comments give the names of the node's parameters.
struct RunParameters
{
  bool start_paused = false;  ///< ~start_paused
  std::size_t threads = 0;    ///< ~threads: see Simulation::setThreads()
  FrameRates rates;           ///< ~rates/particles, bins, base, statistics, observed [1/s of simulated time]

  /// ~limits/inclination/min, max and so on for frequency and amplitude
  std::array<Setpoint, QUANTITIES> setpoints = usualSetpoints();  ///< in the order of Quantity

  double window = BIN_WINDOW;  ///< ~window: over which ~bins counts what left lately [s]

  SlewRates slew_rates;  ///< ~limits/inclination/slew_rate and so on [unit/s]

  DriveParameters drives;    ///< ~actuators
  SensorParameters sensors;  ///< ~sensors
};

/// Records runs, one after the other; recording may be off.
class RunRecording : public FrameSink
{
public:
  virtual bool on() const = 0;
  virtual const FrameRates& rates() const = 0;

  /// Ends the recording of a run and begins that of the next.
  virtual void openNext() = 0;

  /// Later frames are not recorded.
  virtual void close() = 0;
};

/// The result of a request.
struct Outcome
{
  bool success = true;
  std::string message;  ///< on failure the reason, otherwise a note or empty
};

/// Controls a run: pause, step, reset, pour, setpoints. Independent of topics and wall time.
class RunControl
{
public:
  /// Advances the run one stride towards a time, by advanceTo(). Returns false to abort the step.
  using Stride = std::function<bool(double time)>;

  /// @param scene YAML of the scene, kept for resets; @param source its name in error messages
  /// @param recording takes frames and setpoints; outlives this
  /// @param pour_observer for each pour at the start of a run; see Simulation
  /// @throws SceneError, std::invalid_argument if the disks of the scene overlap
  RunControl(const YAML::Node& scene, const std::string& source, const RunParameters& parameters,
             RunRecording& recording, RunLog log = {}, PourObserver pour_observer = {});

  /// Adds a sink for the frames of this run and the later ones, which outlives this.
  void addSink(FrameSink& sink);

  /// Calls the observer with each disk that leaves, of this run and the later ones.
  void observeExits(ExitObserver observer) { exit_observer_ = std::move(observer); }

  /// Calls the observer with each reading when it is sent, of this run and the later ones.
  void observeSensors(SensorObserver observer) { sensor_observer_ = std::move(observer); }

  /// Hands the first frames to the sinks.
  void begin();

  /// Hands the last frames to the sinks and closes the recording.
  void end();

  const Run& run() const { return *run_; }

  /// The warnings of the present scene: see Scene.
  const std::vector<std::string>& sceneWarnings() const { return scene_warnings_; }

  /// A warning of one line if the base may turn too fast for its walls, otherwise empty. See fastTurnText().
  std::string turnWarning() const;
  bool paused() const { return paused_; }
  void pause();
  void unpause();

  /// Advances to a time, at most to the next frame, move of a drive, reading, or the end.
  void advanceTo(double time);

  /// Advances by `duration` [s] or to the end, in strides. Reaching the end early is a success, and the
  /// outcome mentions it. An aborted step is a failure; the time already simulated stays.
  Outcome step(double duration, const Stride& stride);

  /// Applies all setpoints, or none if one is refused, and steps.
  /// @param setpoints names and values
  Outcome lockStep(const std::vector<std::pair<std::string, double>>& setpoints, double duration,
                   const Stride& stride);

  /// Restarts at time 0, or at the present time. @param seed 0: the seed of the scene
  Outcome reset(std::uint64_t seed, const std::vector<std::string>& overrides, bool keep_time);

  /// Pours new disks over the base in its present motion. Time continues to the end of the run; at the end of
  /// the run, another duration is added. Fails and changes nothing if the base now overlaps disks of
  /// `initial`.
  Outcome resetWorld();

  Outcome pour(const std::string& species, std::size_t count, const std::optional<Stretch>& between = {});

  /// The setpoint that was asked for last.
  double commanded(Quantity quantity) const { return drives_->asked(quantity); }

  /// Commands a drive at the present time. @pre Setpoint::refusal() of the value is nothing
  void command(Quantity quantity, double value);

  /// Makes a sensor or a drive fail from now on, until a reset of the run.
  /// @param part a quantity, or a sensor by its name in SENSOR_LIST
  Outcome fault(const std::string& part, const std::string& fault);

  /// Sets a scale to zero. @param name of SENSOR_LIST
  void tare(const std::string& name);

private:
  std::optional<std::string> whyNoStep(double duration) const;
  Outcome advance(double duration, const Stride& stride);
  Scene readScene(std::uint64_t seed, const std::vector<std::string>& overrides) const;
  void announce(const Scene& scene) const;
  std::unique_ptr<Run> makeRun(const SceneDefinition& scene, double start_time, double end_time);
  void begin(std::unique_ptr<Run> run, const Drives& drives);
  std::vector<CommandFrame> driveCommands() const;
  void followDrives();

  YAML::Node scene_;
  std::string source_;
  RunParameters parameters_;
  RunRecording& recording_;
  RunLog log_;
  PourObserver pour_observer_;
  std::vector<FrameSink*> sinks_;
  ExitObserver exit_observer_;
  SensorObserver sensor_observer_;
  std::vector<std::string> scene_warnings_;
  std::unique_ptr<Run> run_;
  std::optional<Drives> drives_;  ///< of the run
  std::vector<Sensor> sensors_;   ///< of the run
  bool paused_;
};

}  // namespace ratchet_sieve
