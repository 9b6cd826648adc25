#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "events/event_loop.h"
#include "events/record_sorter.h"
#include "model/random.h"
#include "state/energy_watch.h"
#include "state/machine.h"
#include "state/period_watch.h"

namespace ratchet_sieve
{

/// A run of the machine. What happens to all of the machine at once stands here; what happens to one disk, in
/// the loop. Times are local to the epoch unless said otherwise.
class Run
{
public:
  /// Begins a run at a time of its own clock [s]. See Simulation.
  Run(const SceneDefinition& scene, const Plan& plan, double start_time, const PourObserver& pour_observer);

  /// Takes up a run where it was saved. @throws StateError
  Run(const SceneDefinition& scene, std::string_view saved_state);

  void archive(StateArchive& state)
  {
    state(machine_, random_, *loop_, energy_watch_, start_, now_, settled_, blocks_, fed_);
  }

  const MachineState& machine() const { return machine_.state(); }
  const RunRecord& record() const { return machine_.record(); }
  const CollapseWatch& collapseWatch() const { return machine_.collapseWatch(); }
  const EnergyWatch& energyWatch() const { return energy_watch_; }
  std::uint64_t events() const { return loop_->events(); }
  bool settled() const { return settled_; }
  double now() const { return now_; }

  /// When so many blocks of the series of the means have ended, in the run's time [s].
  double blockEnd(std::uint64_t blocks) const
  {
    return settledTime() + static_cast<double>(blocks) * blockTime();
  }
  MeanSeries meanSeries() const { return record().meanSeries(blockTime()); }

  /// In the run's time [s].
  double startTime() const { return start_; }
  double time() const { return machine().epoch().start + now_; }

  /// @param time in the run's time [s] @throws StallError
  void advanceTo(double time);

  /// Has `command`, given the base's motion and the time, change the motion now.
  template <typename Command>
  void changeMotion(Command&& command)
  {
    loop_->catchUp(now_);
    command(machine_.state().motion(), now_);
    if (const double length = machine_.state().shortenEpoch(now_); length > 0.0)
      moveZero(length);
    loop_->motionChanged(now_);
    periods_.motionChanged(now_);
  }

  /// @throws std::invalid_argument, with nothing changed
  void pour(std::size_t species, std::size_t count);
  void setThreads(std::size_t threads);
  void observeCollisions(CollisionObserver observer);
  void observePeriods(PeriodObserver observer) { periods_.observe(std::move(observer), now_); }

  /// @return how many disks are behind the base's surface
  std::size_t auditOverlaps();

private:
  /// What happens to the machine as a whole: when next, and what is done then.
  struct MachineEvent
  {
    std::optional<double> (Run::*when)() const;
    void (Run::*what)();
  };

  /// All of them; of those at one time the first comes first.
  static const MachineEvent MACHINE_EVENTS[];

  std::unique_ptr<EventLoop> makeLoop();
  double nextMachineEvent() const;

  /// Executes one of the events whose time has come, if there is any.
  bool executeMachineEvent();

  std::optional<double> nextSettle() const;
  void settle();
  std::optional<double> nextBlockEnd() const;
  double blockTime() const;
  void endBlock();
  std::optional<double> nextPeriodSample() const { return periods_.next(); }
  void samplePeriod() { periods_.sample(now_); }
  std::optional<double> nextSegmentEnd() const { return machine().motion().nextChange(); }
  void beginSegment();
  std::optional<double> nextFeed() const;
  void feed();
  std::optional<double> nextEpochEnd() const { return machine().epoch().length; }
  void endEpoch();

  /// @param time of the run [s]
  std::optional<double> local(double time) const { return time - machine().epoch().start; }
  double settledTime() const { return start_ + machine().scene().settle; }
  bool hasPairs() const { return machine().plan().pairs; }
  void moveZero(double length);
  void renewLoop();
  bool hasToStop() const;
  void stopAtATimeOfTheRun();

  /// Tells the loop of the disks from this slot on.
  void announce(std::uint32_t first);

  Machine machine_;
  Random random_;
  std::unique_ptr<EventLoop> loop_;
  EnergyWatch energy_watch_;
  double start_ = 0.0;  ///< of the run [s]
  double now_ = 0.0;
  bool settled_ = false;
  std::uint64_t blocks_ = 0;  ///< of the series of means that have ended
  std::uint64_t fed_ = 0;
  std::size_t threads_ = 1;
  PeriodWatch periods_{machine_.state(), machine_.record().counts().collisions};
  RecordSorter sorter_;
};

}  // namespace ratchet_sieve
