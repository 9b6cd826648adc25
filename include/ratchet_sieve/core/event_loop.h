#pragma once

#include <cstdint>
#include <memory>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

class Machine;

/// Advances a machine's disks from event to event. Times are local to the epoch.
///
/// Nothing here depends on how far a caller asks to advance: the same events happen at the same
/// bits in whatever strides.
class EventLoop
{
public:
  virtual ~EventLoop() = default;

  /// Executes every event up to and including `time`. @throws StallError
  virtual void advanceTo(double time) = 0;

  /// A disk was put into the machine.
  virtual void added(std::uint32_t id, double time) = 0;

  /// The base has begun a new segment of its motion: what was predicted of it does not hold.
  virtual void motionChanged(double time) = 0;

  /// Zero of time moves on by `length`.
  virtual void rebase(double length) = 0;

  /// Events processed so far, collisions and all that serves to find them.
  std::uint64_t events() const { return events_; }

protected:
  std::uint64_t events_ = 0;
};

/// Notices that time has all but stopped for a disk: an inelastic collapse.
class StallWatch
{
public:
  /// More events than this of one disk within the machine's time scale are a collapse.
  static constexpr std::uint32_t MAX_EVENTS_PER_TIME_SCALE = 1000000;

  /// @throws StallError at the event that is one too many
  void count(std::uint32_t id, double time, double time_scale)
  {
    if (time >= window_end_)
    {
      window_end_ = time + time_scale;
      events_ = 0;
    }
    if (++events_ > MAX_EVENTS_PER_TIME_SCALE)
      stalled(id);
  }

  void rebase(double length) { window_end_ -= length; }

private:
  [[noreturn]] static void stalled(std::uint32_t id);

  double window_end_ = 0.0;
  std::uint32_t events_ = 0;
};

/// For disks that do not see each other: every disk is a loop of its own, without a queue.
std::unique_ptr<EventLoop> makeEnsembleLoop(Machine& machine);

/// For disks that collide with each other: one queue over all.
std::unique_ptr<EventLoop> makePairLoop(Machine& machine);

}  // namespace ratchet_sieve
