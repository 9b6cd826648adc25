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
  /// @param opening commands that hold from its start on; their own times do not matter
  /// @param start_time not 0 where new disks are poured at the present time [s]
  /// @param end_time [s]
  /// @param wall_clock by which the real-time factor is measured
  /// @param pour_observer see Simulation
  LiveRun(const SceneDefinition& scene, const FrameRates& rates, std::vector<CommandFrame> opening,
          double start_time, double end_time,
          FrameSampler::WallClock wall_clock = std::chrono::steady_clock::now,
          const PourObserver& pour_observer = {});

  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  double time() const { return simulation_.time(); }
  double startTime() const { return simulation_.startTime(); }
  double endTime() const { return end_time_; }
  bool finished() const { return time() >= end_time_ || stopped(); }

  /// Why it has stopped: an inelastic collapse; nothing if it has not.
  const std::optional<std::string>& stopReason() const { return stop_reason_; }
  bool stopped() const { return stop_reason_.has_value(); }

  /// Hands frames to a recorder as well, at rates of its own. @param recorder outlives this
  void record(FrameSink& recorder, const FrameRates& rates);

  /// When the next frame is due, or the end where that is earlier [s].
  double nextTime() const;

  /// Advances no further than nextTime(), and hands on the frames that are due.
  void advanceTo(double time, FrameSink& sink);

  /// Hands on the frames that are due; at the beginning the scene, the first of each kind and the opening
  /// commands.
  void takeDue(FrameSink& sink);

  /// Hands on one of each kind as things stand, where none was taken at this very time.
  void takeAll(FrameSink& sink);

  /// Gives the run a command at its present time, and hands it on. @throws std::invalid_argument
  void give(CommandFrame command, FrameSink& sink);

  /// See FrameSampler.
  void setUnderWay(bool under_way);

  const Simulation& simulation() const { return simulation_; }

  /// The present state, whether a frame is due or not.
  ParticleFrame particles() const { return makeParticleFrame(simulation_); }
  BinFrame bins() const { return makeBinFrame(simulation_); }
  BaseFrame base() const { return makeBaseFrame(simulation_); }
  /// Over the periods that ended since the last one that was due to be published; over none where nobody
  /// wanted statistics until now. Without the real-time factor.
  StatisticsFrame statistics() const;

  /// From now on periods are observed for statistics(), also while no sink wants statistics.
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
  std::vector<CommandFrame> opening_;  ///< that nobody was shown yet
  std::optional<std::string> stop_reason_;
};

}  // namespace ratchet_sieve
