#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// Takes frames at the exact times start + k / rate, so that no rounding adds up, and a last one of each
/// kind. What the sink does not want is not made; its times go by all the same.
class FrameSampler
{
public:
  using WallClock = std::function<std::chrono::steady_clock::time_point()>;

  FrameSampler(const FrameRates& rates, double start_time,
               WallClock wall_clock = std::chrono::steady_clock::now);

  /// Whether the run is under way, as it is from the start, or stands still: wall time that it stood still is
  /// left out of the real-time factor.
  void setUnderWay(bool under_way);

  /// The next time at which a frame is due [s]; infinity if every rate is 0. Advance the simulation no
  /// further than this.
  double nextTime() const;

  /// What its statistics average over: hand it all of Simulation::observePeriods(), and restart the window
  /// where those were not observed for a while.
  void take(const PeriodRecord& period) { window_.take(period); }
  void restartWindow(const Simulation& simulation) { window_.restart(simulation); }
  const StatisticsWindow& window() const { return window_; }

  /// Hands every frame that is due at simulation.time() to the sink; the first call also the scene.
  void takeDue(const Simulation& simulation, FrameSink& sink);

  /// Hands a last frame of every kind to the sink, where none was taken at this very time.
  void takeLast(const Simulation& simulation, FrameSink& sink);

private:
  struct Stream
  {
    double rate = 0.0;
    std::uint64_t next_index = 0;
    std::optional<double> last_time;
  };
  double dueTime(const Stream& stream) const;
  bool passIfDue(Stream& stream, double time) const;  ///< its time has then come and gone
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
  ParticleFrame particle_frame_;             ///< one buffer for all
  StatisticsWindow window_;
  std::optional<double> last_statistics_;  ///< that was handed on [s]
  std::chrono::steady_clock::time_point last_statistics_wall_;
  std::optional<std::chrono::steady_clock::time_point> stood_since_;  ///< while it is not under way
};

}  // namespace ratchet_sieve
