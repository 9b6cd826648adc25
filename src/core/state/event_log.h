#pragma once

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "state/observer.h"
#include "state/thread_buffer.h"

namespace ratchet_sieve
{

class SystemState;

/// Tells the observers of a run of contacts, flights and departures, in the order of time: at once, or once
/// those of independent disks can be put into it.
class EventLog
{
public:
  /// @param system outlives this
  explicit EventLog(const SystemState& system);

  /// For a thread, if several advance disks at the same time.
  ThreadBuffer buffer() const { return {species_, wants(Observer::CONTACTS), wants(Observer::FLIGHTS)}; }

  /// A contact of approaching surfaces.
  void collided(const ContactOutcome& outcome)
  {
    if (wants(Observer::CONTACTS))
      tell(outcome);
  }

  /// @param buffer of the thread, if several advance disks at the same time
  [[gnu::always_inline]] void flew(std::uint32_t slot, const Disk& disk, double end, ThreadBuffer* buffer)
  {
    if (!wants(Observer::FLIGHTS))
      return;
    const Flight flight{slot, disk, end};
    if (buffer != nullptr)
      buffer->flew(flight);
    else
      tell(flight);
  }

  void departed(const Departure& departure, ThreadBuffer* buffer)
  {
    if (buffer != nullptr)
      buffer->departed(departure);
    else
      tell(departure);
  }

  /// Takes what a thread has to report, until deliver().
  void take(std::vector<PendingReport>&& reports);

  /// Tells observers of what is pending, in the order of time. @pre no later contact or flight ends earlier
  void deliver();

  /// Whether reports of contacts or flights of independent disks are kept until deliver(): they take memory.
  bool collects() const { return ordered_ && wants(Observer::CONTACTS | Observer::FLIGHTS); }

  /// Whether an observer wants the blocks of the mean series.
  bool wantsBlocks() const { return wants(Observer::BLOCKS); }

  /// Adds an observer, which is told of what it subscribes to from now on. @return it
  template <typename Added>
  Added* add(std::unique_ptr<Added> observer)
  {
    Added* added = observer.get();
    observers_.push_back(std::move(observer));
    noteSubscriptions();
    return added;
  }

  /// Calls `observer` after each collision. An empty function removes the observer.
  void observeCollisions(CollisionObserver observer)
  {
    on_collision_ = std::move(observer);
    noteSubscriptions();
  }
  void observeExits(ExitObserver observer) { on_exit_ = std::move(observer); }

  // See Observer.
  void entered(const Disk& disk, double time) { callAll(&Observer::entered, disk, time); }
  void restart(double time) { callAll(&Observer::restart, time); }
  void endBlock(double time) { callAll(&Observer::endBlock, time); }
  void endSegment(double time)
  {
    deliver();
    callAll(&Observer::endSegment, time);
  }
  void rebase(double length) { callAll(&Observer::rebase, length); }

  /// Only the disks at these slots stay.
  void keep(const std::vector<std::uint32_t>& slots);

  /// @throws StateError if the state is not of this number of slots
  void archive(StateArchive& state, std::size_t slots);

private:
  template <typename Hook, typename... Values>
  void callAll(Hook hook, const Values&... values)
  {
    for (const auto& observer : observers_)
      ((*observer).*hook)(values...);
  }

  bool wants(unsigned subscriptions) const { return (subscriptions_ & subscriptions) != 0; }
  void noteSubscriptions();

  /// Tells observers of it, or keeps it until deliver().
  template <typename What>
  [[gnu::noinline]] void tell(const What& what)
  {
    if (ordered_)
      pending_.emplace_back(what);
    else
      deliverNow(what);
  }
  void deliverNow(const ContactOutcome& outcome);
  void deliverNow(const Flight& flight);
  void deliverNow(const Departure& departure);

  const SystemState& system_;
  bool ordered_;  ///< whether disks are independent
  std::size_t species_;
  std::vector<std::unique_ptr<Observer>> observers_;
  unsigned subscriptions_ = 0;  ///< of all observers and of the callers
  std::vector<PendingReport> pending_;
  CollisionObserver on_collision_;
  ExitObserver on_exit_;
};

}  // namespace ratchet_sieve
