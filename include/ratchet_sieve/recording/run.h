#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/frame_sink.h"

namespace ratchet_sieve
{

/// A simulation that hands frames to sinks while it runs: what runToEnd(), RunControl and Resimulation have
/// in common. Each sink gets frames at rates of its own, at the exact times startTime() + k / rate, so that
/// no rounding error accumulates, and a last one of each kind. A frame that it does not want is skipped.
/// Times are simulated times.
class Run
{
public:
  using Clock = std::chrono::steady_clock;
  using WallClock = std::function<Clock::time_point()>;

  /// @param simulation outlives this
  /// @param end_time [s]
  /// @param wall_clock for the real-time factor
  Run(Simulation& simulation, double end_time, WallClock wall_clock = Clock::now);

  /// Keeps the simulation.
  Run(Simulation&& simulation, double end_time, WallClock wall_clock = Clock::now);
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

  /// The time of the next frame or the end of the run, whichever is earlier [s]. @pre the simulation is
  /// advanced no further than this
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

  /// Whether the run is under way (the default) or paused. Wall time in a pause does not count for the
  /// real-time factor.
  void setUnderWay(bool under_way);

  /// See Simulation::observeExits().
  void observeExits(ExitObserver observer) { simulation_.observeExits(std::move(observer)); }

  const Simulation& simulation() const { return simulation_; }

  /// The present state, whether a frame is due or not. Statistics are over the periods since the last
  /// statistics frame that was due for the first sink; over none if no sink has wanted statistics so far.
  /// They leave real_time_factor at 0.
  template <typename Frame>
  Frame now() const
  {
    return makeFrame<Frame>(simulation_,
                            std::is_same_v<Frame, StatisticsFrame> ? presentWindow() : StatisticsWindow());
  }

  /// Simulated over wall time between the last two statistics frames that were due for the first sink; 0
  /// before.
  double realTimeFactor() const { return streams_.empty() ? 0.0 : streams_.front().real_time_factor; }

  /// From now on periods are observed for now<StatisticsFrame>() even if no sink wants statistics.
  void keepStatistics() { statistics_kept_ = true; }

private:
  /// The frames of one kind for one sink.
  struct Series
  {
    double rate = 0.0;
    std::uint64_t next_index = 0;
    std::optional<double> last_time;
  };

  /// The frames for one sink.
  struct Stream
  {
    FrameSink& sink;
    std::array<Series, FRAME_KINDS> series = {};  ///< in the order of FrameKind
    bool scene_taken = false;
    StatisticsWindow window = {};
    std::optional<double> last_statistics = {};  ///< time of the last statistics frame, wanted or not [s]
    Clock::time_point last_statistics_wall = {};
    double real_time_factor = 0.0;  ///< of that frame

    template <typename Frame>
    Series& of()
    {
      return series[static_cast<std::size_t>(kindOf<Frame>())];
    }
  };

  StatisticsWindow presentWindow() const;
  bool statisticsWanted() const;
  double dueTime(const Series& series) const;
  bool passIfDue(Series& series) const;  ///< returns true and moves to the next time if due
  void takeDue(Stream& stream);
  template <typename Frame>
  void take(Stream& stream);
  void measureSpeed(Stream& stream) const;
  Clock::time_point wallTime() const;

  std::unique_ptr<Simulation> kept_;  ///< the simulation, if the run keeps it
  Simulation& simulation_;
  double end_time_;
  WallClock wall_clock_;
  std::vector<Stream> streams_;
  std::vector<CommandFrame> opening_;             ///< opening commands not yet handed over
  std::optional<Clock::time_point> stood_since_;  ///< start of the present pause
  Clock::duration stood_{};                       ///< in all earlier pauses
  bool statistics_kept_ = false;
  bool periods_observed_ = false;
  std::optional<std::string> stop_reason_;
};

}  // namespace ratchet_sieve
