#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "events/event_loop.h"
#include "model/random.h"
#include "observe/period_watch.h"
#include "observe/run_observers.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// What advances a system: a loop for the events of single disks, and the events of the whole machine. Times
/// are local to the epoch unless stated otherwise.
class Engine
{
public:
  /// Begins a run at `start_time` of the run [s]. See Simulation.
  Engine(const SceneDefinition& scene, double start_time, const PourObserver& pour_observer);

  /// Resumes a saved run. @throws StateError
  Engine(const SceneDefinition& scene, std::string_view saved_state);

  /// @throws StateError
  void archive(StateArchive& state);

  const SystemState& state() const { return state_; }
  SystemState& state() { return state_; }
  const RunObservers& observers() const { return observers_; }
  RunObservers& observers() { return observers_; }
  std::uint64_t events() const { return loop_->events(); }
  std::uint64_t eventsInStrips() const { return loop_->eventsInStrips(); }
  bool settled() const { return settled_; }
  double now() const { return now_; }

  /// The time at which this number of blocks of the mean series has ended, in the run's time [s].
  double blockEnd(std::uint64_t blocks) const
  {
    return settledTime() + static_cast<double>(blocks) * blockTime();
  }
  MeanSeries meanSeries() const { return state_.sums().averages.series(blockTime()); }
  FlowSeries flowSeries() const { return observers_.flowSeries(settledTime(), blockTime()); }

  /// In the run's time [s].
  double startTime() const { return start_; }
  double time() const { return state_.epoch().start + now_; }

  /// @param time in the run's time [s] @throws StallError
  void advanceTo(double time);

  /// Calls `command` with the base's motion and the time; it changes the motion at that time.
  template <typename Command>
  void changeMotion(Command&& command)
  {
    loop_->catchUp(now_);
    state_.changeMotion(command, now_);
    if (const double length = state_.shortenEpoch(now_); length > 0.0)
      moveZero(length);
    loop_->motionChanged(now_);
    periods_.motionChanged(now_);
  }

  /// @throws std::invalid_argument, or what the observer throws; nothing is changed then
  void pour(std::size_t species, std::size_t count, const Stretch& stretch, const PourObserver& observer);
  /// @param threads 0: one per processor
  void setThreads(std::size_t threads, const StripSettings& strips = {});
  void observePeriods(PeriodObserver observer) { periods_.observe(std::move(observer), now_); }

  /// @return number of disks below the base's surface
  std::size_t auditOverlaps();

private:
  /// An event of the whole machine: its next time and its action.
  struct MachineEvent
  {
    std::optional<double> (Engine::*when)() const;
    void (Engine::*what)();
  };

  /// All of them; at the same time, the first in the list is executed first.
  static const MachineEvent MACHINE_EVENTS[];

  std::unique_ptr<EventLoop> makeLoop();
  double nextMachineEvent() const;

  /// Executes one of the events that are due. @return whether there was one
  bool executeMachineEvent();

  std::optional<double> nextSettle() const;
  void settle();
  std::optional<double> nextBlockEnd() const;
  double blockTime() const;
  void endBlock();
  std::optional<double> nextPeriodSample() const { return periods_.next(); }
  void samplePeriod() { periods_.sample(now_); }
  std::optional<double> nextSegmentEnd() const { return state_.motion().nextChange(); }
  void beginSegment();
  std::optional<double> nextFeed() const;
  void feed();
  void drawNextFeed();
  void pourOnto(const Stretch& stretch, std::size_t species, std::size_t count, const PourObserver& observer,
                const FedDisk* own = nullptr);
  std::optional<double> nextEpochEnd() const { return state_.epoch().length; }
  void endEpoch();

  /// @param time of the run [s]
  std::optional<double> local(double time) const { return time - state_.epoch().start; }
  double settledTime() const { return start_ + state_.scene().settle; }
  bool hasPairs() const { return state_.plan().pairs; }
  void moveZero(double length);
  void renewLoop();
  void stopAtATimeOfTheRun();

  /// Adds the disks from slot `first` on to the loop.
  void announce(std::uint32_t first);

  SystemState state_;
  RunObservers observers_{state_};
  Random random_;

  /// Of the feed's times and species alone: they are the same in every setting of a machine.
  Random feed_random_;
  std::unique_ptr<EventLoop> loop_;
  double start_ = 0.0;  ///< of the run [s]
  double now_ = 0.0;
  bool settled_ = false;
  std::uint64_t blocks_ = 0;  ///< completed blocks of the mean series
  std::uint64_t fed_ = 0;
  double next_feed_ = 0.0;  ///< of the run [s]
  std::size_t threads_ = 1;
  StripSettings strips_;
  PeriodWatch periods_{state_};
};

}  // namespace ratchet_sieve
