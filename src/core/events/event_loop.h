#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

class SystemState;

/// How a layer is divided among threads and into strips (PairStrips). The results do not depend on it.
struct StripSettings
{
  std::size_t disks_per_thread = 1500;  ///< with fewer, threads cost more than they gain

  /// Between these, strips pay on one thread: they fit into its cache. With more, their memory is worth more.
  std::size_t least_on_one_thread = 60000;
  std::size_t most_on_one_thread = 500000;

  std::size_t disks_per_strip = 1500;    ///< at most, so that what belongs to them fits into a core's cache
  std::int32_t columns_per_strip = 200;  ///< at least, so that there is room for what is left to the cuts
  std::int32_t margin = 4;               ///< columns that stay frozen next to those an event left out touches
  double events_per_column = 1.5;        ///< in a window
};

/// Advances the disks of a system from event to event. Times are local to the epoch.
///
/// The results do not depend on how a caller divides the time into calls: the same events occur with the same
/// bits.
class EventLoop
{
public:
  virtual ~EventLoop() = default;

  /// Executes every event up to and including `time`, unless the CollapseWatch stops the run.
  /// @return the time reached
  virtual double advanceTo(double time) = 0;

  /// To be called before an event of the whole machine at a time already reached: executes contacts that the
  /// loop has postponed.
  virtual void catchUp(double /*time*/) {}

  /// The time up to which all contacts are executed after advanceTo(time); from there on disks are in free
  /// flight.
  virtual double executedUntil(double time) const { return time; }

  /// To be called after a disk was added.
  virtual void added(std::uint32_t slot, double time) = 0;

  /// To be called after the base began a new segment of its motion: invalidates predictions that depend on
  /// it.
  virtual void motionChanged(double time) = 0;

  /// Moves the zero of time forward by `length`.
  virtual void rebase(double length) = 0;

  /// To be called at the start of an epoch: checks whether the neighbour search still suits the motion of the
  /// disks.
  /// @return whether it needs a rebuild; then motionChanged() must be called, which does it
  virtual bool outgrown(double /*time*/) { return false; }

  virtual void archive(StateArchive& state) { state(events_); }

  /// Sets the largest number of threads; results do not depend on it.
  /// @pre threads >= 1
  virtual void setThreads(std::size_t /*threads*/, const StripSettings& /*strips*/ = {}) {}

  /// Number of events so far: collisions, and internal events of the search.
  std::uint64_t events() const { return events_; }

  /// Those of them that strips of a layer have executed.
  virtual std::uint64_t eventsInStrips() const { return 0; }

  /// Continues the count of a previous loop.
  void setEvents(std::uint64_t events) { events_ = events; }

protected:
  std::uint64_t events_ = 0;
};

/// For independent disks: every disk has its own loop, without a queue.
std::unique_ptr<EventLoop> makeEnsembleLoop(SystemState& state);

/// For disks that collide with each other: one event queue for all.
std::unique_ptr<EventLoop> makePairLoop(SystemState& state);

/// For disks that collide with each other, by fixed integration steps: Method::STEPS.
std::unique_ptr<EventLoop> makeStepLoop(SystemState& state);

}  // namespace ratchet_sieve
