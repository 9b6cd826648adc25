#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/flow_series.h"
#include "ratchet_sieve/core/observation.h"
#include "state/averages.h"
#include "state/contact_sums.h"
#include "state/energy_watch.h"
#include "state/thread_buffer.h"
#include "state/trajectory_sums.h"

namespace ratchet_sieve
{

class Bins;
class FlowBlocks;

/// The observers of a run: the one list through which every contact, flight and departure goes, and every
/// change of the slots and of the zero of time. Each run has the same standing observers, called without a
/// virtual call; further ones are added.
class Observers
{
public:
  explicit Observers(const SystemState& system);

  /// For a thread, if several advance disks at the same time.
  ThreadBuffer buffer() const { return {species_, wants(Observer::CONTACTS), wants(Observer::FLIGHTS)}; }

  /// Takes an executed contact.
  void collided(const ContactOutcome& outcome, ThreadBuffer* share = nullptr)
  {
    if (share != nullptr)
      return collided(outcome, *share);
    counts_.addOverlap(outcome.overlap);
    if (!outcome.closed)
      return;
    forEachStanding([&](auto& observer) { observer.collided(outcome); });
    if (wants(Observer::CONTACTS))
      tell(outcome);
  }

  // Inlined: a call costs 1 % of a run.
  [[gnu::always_inline]] void flew(const Flight& flight, ThreadBuffer* share = nullptr)
  {
    trajectories_.flew(flight);
    if (!wants(Observer::FLIGHTS))
      return;
    if (share != nullptr)
      share->flew(flight);
    else
      tell(flight);
  }

  void left(const Departure& departure, ThreadBuffer* share = nullptr)
  {
    forEachStanding([&](auto& observer) { observer.left(departure); });
    if (share != nullptr)
      share->left(departure);
    else
      tell(departure);
  }

  /// Takes what a thread has observed. What added observers are told of waits for deliver().
  void merge(ThreadBuffer&& share);

  /// The sums of all disks.
  struct DiskSums
  {
    std::vector<Trajectory> trajectories;
    BaseImpulses impulses;
    ContactTimes contact_times{false};
  };
  void copyTo(DiskSums& sums) const
  {
    sums.trajectories = trajectories_.all();
    sums.impulses = impulses_;
    sums.contact_times = contact_times_;
  }
  void restore(const DiskSums& sums)
  {
    trajectories_.setAll(sums.trajectories);
    impulses_ = sums.impulses;
    contact_times_ = sums.contact_times;
  }

  /// The sums of one disk.
  struct OneDisksSums
  {
    Trajectory trajectory;
    Eigen::Vector2d impulse;
    double contact_time;
  };
  OneDisksSums sumsOf(std::uint32_t slot) const
  {
    return {trajectories_[slot], impulses_.of(slot), contact_times_.of(slot)};
  }
  void restore(std::uint32_t slot, const OneDisksSums& sums)
  {
    trajectories_[slot] = sums.trajectory;
    impulses_.set(slot, sums.impulse);
    contact_times_.set(slot, sums.contact_time);
  }

  void prefetchSums(std::uint32_t slot) const
  {
    prefetch(trajectories_[slot]);
    prefetch(impulses_.of(slot));
  }

  /// Adds an observer, which is told of what it subscribes to from now on. @return it
  template <typename Added>
  Added* add(std::unique_ptr<Added> observer)
  {
    Added* added = observer.get();
    added_.push_back(std::move(observer));
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

  /// See Simulation. @param time the present time of the run [s]
  void keepExits(double length, double time)
  {
    kept_length_ = length;
    kept_from_ = time;
    exits_.clear();
  }
  ExitWindow exitWindow(double time, double not_before) const;

  /// Whether reports of contacts or flights of independent disks are kept, for delivery in the order of time:
  /// they take memory.
  bool collects() const { return ordered_ && wants(Observer::CONTACTS | Observer::FLIGHTS); }

  /// Tells added observers of what is pending, in the order of time. @pre no later contact or flight ends
  /// earlier
  void deliver();

  void reserve(std::size_t count) { callAll(&Observer::reserve, count); }
  void entered(const Disk& disk, double time) { callAll(&Observer::entered, disk, time); }
  void compact(const Compaction& compaction) { callAll(&Observer::compact, compaction); }
  void restart(double time) { callAll(&Observer::restart, time); }
  void endBlock(double time) { callAll(&Observer::endBlock, time); }
  void endEpoch(double time) { callAll(&Observer::endEpoch, time); }
  void endSegment(double time)
  {
    deliver();
    callAll(&Observer::endSegment, time);
  }
  void rebase(double length)
  {
    deliver();
    callAll(&Observer::rebase, length);
  }

  /// Whether blocks of the mean series are recorded.
  bool keepsBlocks() const { return averages_.keepsSeries() || wants(Observer::BLOCKS); }

  /// @throws StateError if the state is not of this number of slots
  void archive(StateArchive& state, std::size_t slots);

  ContactCounts& counts() { return counts_; }
  const ContactCounts& counts() const { return counts_; }
  const SpeciesContacts& speciesContacts() const { return species_contacts_; }
  const ContactTimes& contactTimes() const { return contact_times_; }
  BaseImpulses& impulses() { return impulses_; }
  const BaseImpulses& impulses() const { return impulses_; }
  const Averages& averages() const { return averages_; }
  const EnergyWatch& energyWatch() const { return energy_watch_; }
  TrajectorySums& trajectories() { return trajectories_; }
  const TrajectorySums& trajectories() const { return trajectories_; }
  const std::vector<SpeciesBins>& bins() const;
  std::vector<SpeciesBins>& sizeClassBins();

  /// See FlowBlocks::series().
  FlowSeries flowSeries(double start, double block_time) const;

  /// Of a profile; empty for a sawtooth.
  FaceContacts faceContacts() const { return faces_ ? faces_->contacts() : FaceContacts(); }

  /// What the scene asks for, until `time`; before the end of `settle` as if nothing had happened yet.
  std::vector<Observed> observed(double time, bool settled) const;

private:
  template <typename Call>
  void forEachStanding(Call&& call)
  {
    call(counts_);
    call(species_contacts_);
    call(impulses_);
    call(contact_times_);
    call(averages_);
    call(energy_watch_);
    call(trajectories_);
  }

  /// Of the added ones, too.
  template <typename Call>
  void forEach(Call&& call)
  {
    forEachStanding(call);
    for (const std::unique_ptr<Observer>& observer : added_)
      call(*observer);
  }

  template <typename Hook, typename... Values>
  void callAll(Hook hook, const Values&... values)
  {
    forEach([&](Observer& observer) { (observer.*hook)(values...); });
  }

  bool wants(unsigned subscriptions) const { return (subscriptions_ & subscriptions) != 0; }
  void noteSubscriptions();
  [[gnu::noinline]] void collided(const ContactOutcome& outcome, ThreadBuffer& share);

  /// Tells the added ones of it, or keeps it until deliver().
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
  std::size_t species_;
  bool ordered_;  ///< whether disks are independent

  // Those that read trajectories come before them: a compaction takes them away.
  ContactCounts counts_;
  SpeciesContacts species_contacts_;
  BaseImpulses impulses_;
  ContactTimes contact_times_;
  Averages averages_;
  EnergyWatch energy_watch_;
  TrajectorySums trajectories_;

  CollisionObserver on_collision_;
  ExitObserver on_exit_;
  std::vector<std::unique_ptr<Observer>> added_;
  unsigned subscriptions_ = 0;  ///< of all added ones and of the callers
  std::vector<PendingReport> pending_;
  Bins* bins_;  ///< the first of the added, which are told of departures in the order of time
  const FlowBlocks* flow_ = nullptr;            ///< one of the added, where disks are fed and can leave
  std::vector<const Observable*> observables_;  ///< of the added, in the order of the scene
  const FaceCounts* faces_ = nullptr;           ///< one of the added

  // See keepExits().
  double kept_length_ = 0.0;                                     ///< [s]
  double kept_from_ = -std::numeric_limits<double>::infinity();  ///< in the run's time [s]
  std::deque<std::pair<double, Departure>> exits_;               ///< in the order of time: the run's [s]
};

}  // namespace ratchet_sieve
