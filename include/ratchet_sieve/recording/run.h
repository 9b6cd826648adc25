#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Takes frames at the exact times start + k / rate, so that no rounding error accumulates, and a last one of
/// each kind. A frame that the sink does not want is skipped.
class FrameSampler
{
public:
  using WallClock = std::function<std::chrono::steady_clock::time_point()>;

  FrameSampler(const FrameRates& rates, double start_time,
               WallClock wall_clock = std::chrono::steady_clock::now);

  /// Whether the run is under way (the default) or paused. Wall time in a pause does not count for the
  /// real-time factor.
  void setUnderWay(bool under_way);

  /// The time at which the next frame is due [s]; infinity if every rate is 0. @pre the caller advances the
  /// simulation no further than this
  double nextTime() const;

  /// Takes a period for the statistics: hand over all of Simulation::observePeriods(). Restart the window if
  /// periods were not observed for a while.
  void take(const PeriodRecord& period) { window_.take(period); }
  void restartWindow(const Simulation& simulation) { window_.restart(simulation); }
  const StatisticsWindow& window() const { return window_; }

  /// Hands every frame that is due at simulation.time() to the sink. The first call also hands over the
  /// scene.
  void takeDue(const Simulation& simulation, FrameSink& sink);

  /// Hands a last frame of every kind to the sink, except for kinds that already have a frame of this time.
  void takeLast(const Simulation& simulation, FrameSink& sink);

private:
  struct Stream
  {
    double rate = 0.0;
    std::uint64_t next_index = 0;
    std::optional<double> last_time;
  };
  double dueTime(const Stream& stream) const;
  bool passIfDue(Stream& stream, double time) const;  ///< returns true and moves to the next time if due
  template <typename Frame>
  Stream& stream()
  {
    return streams_[static_cast<std::size_t>(kindOf<Frame>())];
  }
  template <typename Frame>
  void take(const Simulation& simulation, FrameSink& sink);
  double realTimeFactorAt(double time);

  std::chrono::steady_clock::time_point wallTime() const;

  double start_time_;
  WallClock wall_clock_;
  bool scene_taken_ = false;
  std::array<Stream, FRAME_KINDS> streams_;  ///< in the order of FrameKind
  ParticleFrame particle_frame_;             ///< reused for all particle frames
  StatisticsWindow window_;
  std::optional<double> last_statistics_;  ///< time of the last statistics frame [s]
  std::chrono::steady_clock::time_point last_statistics_wall_;
  std::optional<std::chrono::steady_clock::time_point> stood_since_;  ///< start of the present pause
};

/// A simulation that hands frames to sinks while it runs: what runToEnd(), RunControl and Resimulation have
/// in common. Times are simulated times.
class Run
{
public:
  /// @param simulation outlives this
  /// @param end_time [s]
  /// @param wall_clock for the real-time factor
  Run(Simulation& simulation, double end_time,
      FrameSampler::WallClock wall_clock = std::chrono::steady_clock::now);

  /// Keeps the simulation.
  Run(Simulation&& simulation, double end_time,
      FrameSampler::WallClock wall_clock = std::chrono::steady_clock::now);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  /// Also hands frames to this sink, at rates of its own. @param sink outlives this
  void add(FrameSink& sink, const FrameRates& rates);

  /// Applies commands that hold from the start on, and hands them over after the first frames; their own
  /// times are ignored. @pre takeDue() was not called
  void open(std::vector<CommandFrame> commands);

  double time() const { return simulation_.time(); }
  double startTime() const { return simulation_.startTime(); }
  double endTime() const { return end_time_; }
  bool finished() const { return time() >= end_time_ || stopped(); }

  /// Why the run has stopped: an inelastic collapse; nothing if it has not.
  const std::optional<std::string>& stopReason() const { return stop_reason_; }
  bool stopped() const { return stop_reason_.has_value(); }

  /// The time of the next frame or the end of the run, whichever is earlier [s].
  double nextTime() const;

  /// Advances to `time`, at most to nextTime(), and hands over the frames that are due.
  void advanceTo(double time);

  /// Observes periods of the drive for the statistics, if a sink wants these. To be called before the
  /// simulation is advanced, where that is not done by advanceTo().
  void observePeriods();

  /// Hands over the frames that are due. The first call hands over the scene, the first frame of each kind
  /// and the opening commands.
  void takeDue();

  /// Hands over a present frame of each kind, except for kinds that already have a frame of this time.
  void takeAll();

  /// Hands over a frame that is not due.
  void show(const AnyFrame& frame);

  /// Applies a command at the run's present time, and hands it over. @throws std::invalid_argument
  void applyCommand(CommandFrame command);

  /// See FrameSampler.
  void setUnderWay(bool under_way);

  /// See Simulation::observeExits().
  void observeExits(ExitObserver observer) { simulation_.observeExits(std::move(observer)); }

  const Simulation& simulation() const { return simulation_; }

  /// The present state, whether a frame is due or not.
  ParticleFrame particles() const { return makeParticleFrame(simulation_); }
  BinFrame bins() const { return makeBinFrame(simulation_); }
  BaseFrame base() const { return makeBaseFrame(simulation_); }
  ObservedFrame observed() const { return makeObservedFrame(simulation_); }

  /// The statistics over the periods since the last statistics frame that was due for the first sink; over
  /// none if no sink has wanted statistics so far. Leaves real_time_factor at 0.
  StatisticsFrame statistics() const;

  /// From now on periods are observed for statistics() even if no sink wants statistics.
  void keepStatistics() { statistics_kept_ = true; }

private:
  struct Stream
  {
    FrameSink& sink;
    FrameSampler sampler;
  };

  bool statisticsWanted() const;

  std::unique_ptr<Simulation> kept_;  ///< the simulation, if the run keeps it
  Simulation& simulation_;
  double end_time_;
  FrameSampler::WallClock wall_clock_;
  std::vector<Stream> streams_;
  std::vector<CommandFrame> opening_;  ///< opening commands not yet handed over
  bool under_way_ = true;
  bool statistics_kept_ = false;
  bool periods_observed_ = false;
  std::optional<std::string> stop_reason_;
};

}  // namespace ratchet_sieve
