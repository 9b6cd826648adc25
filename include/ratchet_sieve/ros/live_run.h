#pragma once

#include <optional>
#include <string>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/frame_sampler.h"

namespace ratchet_sieve
{

/// A simulation that shows itself while it runs. Its published time goes on from `start_time` while
/// its own, elapsed time begins at 0: so that disks can be poured anew without time leaping back.
class LiveRun
{
public:
  /// @param start_time published time at which the run begins [s]
  /// @param end_time published time at which it ends [s]
  LiveRun(const SceneDefinition& scene, const FrameRates& rates, const SlewRates& slew_rates,
          double start_time, double end_time);

  double elapsed() const { return simulation_.time(); }
  double time() const { return start_time_ + elapsed(); }
  double endTime() const { return end_time_; }
  bool finished() const { return elapsed() >= end_time_ - start_time_ || stopped(); }

  /// Why it goes no further: an inelastic collapse; nothing if it does.
  const std::optional<std::string>& stopReason() const { return stop_reason_; }
  bool stopped() const { return stop_reason_.has_value(); }

  /// Hands frames to a recorder as well, at rates of its own. @param recorder outlives this
  void record(FrameSink& recorder, const FrameRates& rates)
  {
    recording_.emplace(Recording{recorder, {rates, 0.0}});
  }

  /// Elapsed time of the next frame, or of the end where that is earlier [s].
  double nextTime() const;

  /// Advances to an elapsed time, no further than nextTime(), and hands on the frames that are due.
  void advanceTo(double elapsed, FrameSink& sink);

  /// Hands on the frames that are due; at the beginning the scene and the first of each kind.
  void takeDue(FrameSink& sink);

  /// Hands on one of each kind as things stand, where none was taken at this very time.
  void takeAll(FrameSink& sink);

  Simulation& simulation() { return simulation_; }
  const Simulation& simulation() const { return simulation_; }

  /// The present state, whether a frame is due or not.
  ParticleFrame particles() const;
  BinFrame bins() const;
  BaseFrame base() const;
  StatisticsFrame statistics() const;  ///< without rates, which need two frames

private:
  struct Recording
  {
    FrameSink& sink;
    FrameSampler sampler;
  };

  template <typename Frame>
  Frame published(Frame frame) const;

  Simulation simulation_;
  FrameSampler sampler_;
  std::optional<Recording> recording_;
  double start_time_;
  double end_time_;
  std::optional<std::string> stop_reason_;
};

}  // namespace ratchet_sieve
