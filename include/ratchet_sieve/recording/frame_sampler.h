#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

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

}  // namespace ratchet_sieve
