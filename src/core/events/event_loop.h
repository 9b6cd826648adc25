#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

class Machine;
class MachineState;

/// Advances a machine's disks from event to event. Times are local to the epoch.
///
/// Nothing here depends on how far a caller asks to advance: the same events happen at the same
/// bits in whatever strides.
class EventLoop
{
public:
  virtual ~EventLoop() = default;

  /// Executes every event up to and including `time`, unless the machine's CollapseWatch stops the run.
  /// @return how far it came
  virtual double advanceTo(double time) = 0;

  /// Something is about to happen to the machine as a whole, at a time that it has come to: what a loop has
  /// left open of the time before is executed.
  virtual void catchUp(double /*time*/) {}

  /// Until when all contacts up to `time` are executed: disks fly on from there.
  virtual double executedUntil(double time) const { return time; }

  /// A disk was put into the machine.
  virtual void added(std::uint32_t slot, double time) = 0;

  /// The base has begun a new segment of its motion: what was predicted of it does not hold.
  virtual void motionChanged(double time) = 0;

  /// Zero of time moves on by `length`.
  virtual void rebase(double length) = 0;

  /// An epoch has begun: the time to see whether the search for neighbours still fits what the disks do.
  /// @return whether it is changed with the next motionChanged(), which has to be called then
  virtual bool outgrown(double /*time*/) { return false; }

  /// @throws StateError
  virtual void archive(StateArchive& state) { state(events_); }

  /// On how many threads it may run; what comes out does not depend on it.
  /// @pre threads >= 1
  virtual void setThreads(std::size_t /*threads*/) {}

  /// Events processed so far, collisions and all that serves to find them.
  std::uint64_t events() const { return events_; }

  /// Goes on counting where another loop ended.
  void setEvents(std::uint64_t events) { events_ = events; }

protected:
  /// @throws StateError if what was restored is of another number of disks than the machine's
  static void requireDisks(std::size_t count, const MachineState& machine);

  std::uint64_t events_ = 0;
};

/// For disks that do not see each other: every disk is a loop of its own, without a queue.
std::unique_ptr<EventLoop> makeEnsembleLoop(Machine& machine);

/// For disks that collide with each other: one queue over all.
std::unique_ptr<EventLoop> makePairLoop(Machine& machine);

/// For the same disks, by steps of time: Method::STEPS.
std::unique_ptr<EventLoop> makeStepLoop(Machine& machine);

}  // namespace ratchet_sieve
