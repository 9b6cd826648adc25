#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/frame_sampler.h"

namespace ratchet_sieve
{

/// A simulation that hands frames to sinks while it runs. Times are simulated times.
class LiveRun
{
public:
  /// @param opening commands that hold from the start on; their own times are ignored
  /// @param start_time present simulated time if new disks are poured during a session, otherwise 0 [s]
  /// @param end_time [s]
  /// @param wall_clock for the real-time factor
  /// @param pour_observer see Simulation
  LiveRun(const SceneDefinition& scene, const FrameRates& rates, std::vector<CommandFrame> opening,
          double start_time, double end_time,
          FrameSampler::WallClock wall_clock = std::chrono::steady_clock::now,
          const PourObserver& pour_observer = {});

  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  void setThreads(std::size_t threads) { simulation_.setThreads(threads); }

  double time() const { return simulation_.time(); }
  double startTime() const { return simulation_.startTime(); }
  double endTime() const { return end_time_; }
  bool finished() const { return time() >= end_time_ || stopped(); }

  /// Why the run has stopped: an inelastic collapse; nothing if it has not.
  const std::optional<std::string>& stopReason() const { return stop_reason_; }
  bool stopped() const { return stop_reason_.has_value(); }

  /// Also hands frames to a recorder, at rates of its own. @param recorder outlives this
  void record(FrameSink& recorder, const FrameRates& rates);

  /// The time of the next frame or the end of the run, whichever is earlier [s].
  double nextTime() const;

  /// Advances to `time`, at most to nextTime(), and hands over the frames that are due.
  void advanceTo(double time, FrameSink& sink);

  /// Hands over the frames that are due. The first call hands over the scene, the first frame of each kind
  /// and the opening commands.
  void takeDue(FrameSink& sink);

  /// Hands over a present frame of each kind, except for kinds that already have a frame of this time.
  void takeAll(FrameSink& sink);

  /// Applies a command at the run's present time, and hands it over. @throws std::invalid_argument
  void applyCommand(CommandFrame command, FrameSink& sink);

  /// See FrameSampler.
  void setUnderWay(bool under_way);

  const Simulation& simulation() const { return simulation_; }

  /// The present state, whether a frame is due or not.
  ParticleFrame particles() const { return makeParticleFrame(simulation_); }
  BinFrame bins() const { return makeBinFrame(simulation_); }
  BaseFrame base() const { return makeBaseFrame(simulation_); }
  ObservedFrame observed() const { return makeObservedFrame(simulation_); }
  /// The statistics over the periods since the last statistics frame that was due; over none if no sink has
  /// wanted statistics so far. Leaves real_time_factor at 0.
  StatisticsFrame statistics() const;

  /// From now on periods are observed for statistics() even if no sink wants statistics.
  void keepStatistics() { statistics_kept_ = true; }

private:
  struct Recording
  {
    FrameSink& sink;
    FrameSampler sampler;
  };

  void show(const CommandFrame& command, FrameSink& sink);
  void observePeriods(bool observe);
  bool statisticsWanted(const FrameSink& sink) const;

  Simulation simulation_;
  FrameSampler::WallClock wall_clock_;
  FrameSampler sampler_;
  bool under_way_ = true;
  bool statistics_kept_ = false;
  bool periods_observed_ = false;
  std::optional<Recording> recording_;
  double end_time_;
  std::vector<CommandFrame> opening_;  ///< opening commands not yet handed over
  std::optional<std::string> stop_reason_;
};

}  // namespace ratchet_sieve
