#pragma once

#include <vector>

#include "ratchet_sieve/core/results.h"
#include "ratchet_sieve/core/state_archive.h"
#include "state/disk_events.h"

namespace ratchet_sieve
{

/// Observes what happens to the disks of a run, and changes none of it: the EventLog tells it. A hook that is
/// not overridden does nothing. Times are local to the epoch. The system that an observer is given outlives
/// it.
class Observer
{
public:
  /// What observers are told of only where one of them subscribes to it. All are told of departures.
  enum Subscription : unsigned
  {
    CONTACTS = 1,
    FLIGHTS = 2,
    BLOCKS = 4  ///< of the mean series
  };

  Observer() = default;
  Observer(const Observer&) = default;
  Observer& operator=(const Observer&) = default;
  virtual ~Observer() = default;

  virtual unsigned subscriptions() const { return 0; }

  /// A contact of approaching surfaces, after its execution.
  virtual void collided(const ContactOutcome& /*outcome*/) {}

  /// A flight, before the disk's is replaced by the next.
  virtual void flew(const Flight& /*flight*/) {}
  virtual void departed(const Departure& /*departure*/) {}

  /// A disk is about to be added at the next slot.
  virtual void entered(const Disk& /*disk*/, double /*time*/) {}

  /// A number of each disk that the observer keeps, if it does: entered() adds to it. It is compacted and
  /// archived as all that is kept per slot.
  virtual std::vector<double>* perSlot() { return nullptr; }

  /// The end of `settle`: the means begin anew.
  virtual void restart(double /*time*/) {}

  /// A block of the mean series ends.
  virtual void endBlock(double /*time*/) {}

  /// A segment of the base's motion ends. An observer of the motion takes into account now what disks in
  /// flight did until then, because afterwards the motion before `time` is not known.
  virtual void endSegment(double /*time*/) {}

  /// The zero of time is about to be moved forward by `length`.
  virtual void rebase(double /*length*/) {}

  /// @throws StateError
  virtual void archive(StateArchive& /*state*/) {}
};

}  // namespace ratchet_sieve
