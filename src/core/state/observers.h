#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "ratchet_sieve/core/observation.h"
#include "state/averages.h"
#include "state/bins.h"
#include "state/contact_sums.h"
#include "state/energy_watch.h"
#include "state/thread_buffer.h"
#include "state/trajectory_sums.h"

namespace ratchet_sieve
{

class RecentExits;

/// The observers of a run: the one list through which every contact, flight and departure goes, and every
/// change of the slots and of the zero of time. Each run has the same standing observers, called without a
/// virtual call; further ones are added.
class Observers
{
public:
  explicit Observers(const SystemState& system);

  /// Of a thread, if several advance disks at the same time.
  class Share : public ThreadBuffer
  {
  public:
    explicit Share(const Observers& observers)
        : ThreadBuffer(observers.species_, !observers.of_contacts_.empty(), !observers.of_flights_.empty())
    {
    }
  };

  /// Takes an executed contact.
  void collided(const ContactOutcome& outcome, Share* share = nullptr)
  {
    if (share != nullptr)
      return collided(outcome, *share);
    counts_.addOverlap(outcome.overlap);
    if (!outcome.closed)
      return;
    forEachStanding([&](auto& observer) { observer.collided(outcome); });
    if (!of_contacts_.empty())
      tell(outcome);
  }

  void flew(const Flight& flight, Share* share = nullptr)
  {
    forEachStanding([&](auto& observer) { observer.flew(flight); });
    if (!of_flights_.empty())
      share != nullptr ? share->flew(flight) : tell(flight);
  }

  void left(const Departure& departure)
  {
    forEachStanding([&](auto& observer) { observer.left(departure); });
    if (!of_departures_.empty())
      tell(departure);
  }

  /// Takes what a thread has observed. What added observers are told of waits for deliver().
  void merge(Share&& share);

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

  /// The time of a disk's last contact is beside its sums.
  double contactTime(std::uint32_t slot) const { return contact_times_.of(slot); }
  void setContactTime(std::uint32_t slot, double time) { contact_times_.set(slot, time); }

  /// The sums of a disk that SIMD batches take along.
  RowSums rowSums(std::uint32_t slot) const
  {
    const Trajectory& sums = trajectories_[slot];
    const Eigen::Vector2d& impulse = impulses_.of(slot);
    return {sums.offset, sums.translation, sums.rotation, sums.angle, impulse.x(), impulse.y()};
  }
  void setRowSums(std::uint32_t slot, const RowSums& sums)
  {
    Trajectory& trajectory = trajectories_[slot];
    trajectory.offset = sums.offset;
    trajectory.translation = sums.translation;
    trajectory.rotation = sums.rotation;
    trajectory.angle = sums.angle;
    impulses_.set(slot, {sums.impulse_x, sums.impulse_y});
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
    sortBySubscription();
    return added;
  }
  void remove(const Observer* observer);

  /// Calls `observer` after each collision. An empty function removes the observer.
  void observeCollisions(CollisionObserver observer);
  void observeExits(ExitObserver observer);

  /// See Simulation. @param time the present time of the run [s]
  void keepExits(double length, double time);
  ExitWindow exitWindow(double time, double not_before) const;

  /// Whether reports of contacts or flights of independent disks are kept, for delivery in the order of time:
  /// they take memory.
  bool collects() const { return ordered_ && !(of_contacts_.empty() && of_flights_.empty()); }

  /// Tells added observers of what is pending, in the order of time. @pre no later contact or flight ends
  /// earlier
  void deliver();

  void reserve(std::size_t count) { callAll(&Observer::reserve, count); }
  void entered(const Disk& disk) { callAll(&Observer::entered, disk); }
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
  bool keepsBlocks() const { return averages_.keepsSeries() || blocks_wanted_; }

  MeanSeries meanSeries(double block_time) const { return averages_.series(block_time); }

  /// @throws StateError if the state is not of this number of slots
  void archive(StateArchive& state, std::size_t slots);

  ContactCounts& counts() { return counts_; }
  const ContactCounts& counts() const { return counts_; }
  const SpeciesContacts& speciesContacts() const { return species_contacts_; }
  const ContactTimes& contactTimes() const { return contact_times_; }
  const BaseImpulses& impulses() const { return impulses_; }
  const Averages& averages() const { return averages_; }
  const EnergyWatch& energyWatch() const { return energy_watch_; }
  TrajectorySums& trajectories() { return trajectories_; }
  const TrajectorySums& trajectories() const { return trajectories_; }
  const std::vector<SpeciesBins>& bins() const { return bins_->ofSpecies(); }

  /// Of a profile; empty for a sawtooth.
  FaceContacts faceContacts() const { return faces_ ? faces_->contacts() : FaceContacts(); }

  /// What the scene asks for, until `time`.
  std::vector<Observed> observed(double time) const;

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

  template <typename Hook, typename Value>
  void callAll(Hook hook, const Value& value)
  {
    forEach([&](Observer& observer) { (observer.*hook)(value); });
  }

  [[gnu::noinline]] void collided(const ContactOutcome& outcome, Share& share);

  /// Tells the added ones of it, or keeps it until deliver().
  template <typename What>
  [[gnu::noinline]] void tell(const What& what);
  void deliverNow(const ContactOutcome& outcome);
  void deliverNow(const Flight& flight);
  void deliverNow(const Departure& departure);
  void sortBySubscription();

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

  std::vector<std::unique_ptr<Observer>> added_;
  std::vector<Observer*> of_contacts_;  ///< of the added ones: those who subscribe to contacts
  std::vector<Observer*> of_flights_;
  std::vector<Observer*> of_departures_;
  bool blocks_wanted_ = false;
  std::vector<PendingReport> pending_;
  const Bins* bins_;  ///< the first of the added, which are told of departures in the order of time
  std::vector<const Observable*> observables_;  ///< of the added, in the order of the scene
  const Observer* collision_report_ = nullptr;  ///< one of the added
  const Observer* exit_report_ = nullptr;       ///< one of the added
  const FaceCounts* faces_ = nullptr;           ///< one of the added
  const RecentExits* recent_exits_ = nullptr;   ///< one of the added
};

}  // namespace ratchet_sieve
