#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "ratchet_sieve/core/mean_series.h"
#include "ratchet_sieve/core/observation.h"
#include "state/accuracy_series.h"
#include "state/base_impulses.h"
#include "state/bins.h"
#include "state/contact_counts.h"
#include "state/contact_times.h"
#include "state/energy_watch.h"
#include "state/face_counts.h"
#include "state/notices.h"
#include "state/observable.h"
#include "state/species_averages.h"
#include "state/species_contacts.h"
#include "state/trajectory_sums.h"

namespace ratchet_sieve
{

/// The observers of a run: the one list through which every contact, flight and departure goes, and every
/// change of the slots and of the zero of time. Each run has the same standing observers, called without a
/// virtual call; further ones are added.
class Observers
{
public:
  /// @param system outlives this
  explicit Observers(const SystemState& system);

  class Share;

  /// Takes an executed contact. @param share of the thread, if several advance disks at the same time
  void take(const ContactOutcome& outcome, Share* share = nullptr)
  {
    if (share != nullptr)
      return take(outcome, *share);
    counts().takeOverlap(outcome.overlap);
    if (!outcome.closed)
      return;
    forEachStanding([&](auto& observer) { observer.take(outcome); });
    if (!of_contacts_.empty())
      tell(outcome);
  }

  /// @param share as in take()
  void flew(const Flight& flight, Share* share = nullptr)
  {
    forEachStanding([&](auto& observer) { observer.flew(flight); });
    if (!of_flights_.empty())
      tell(flight, share);
  }

  void left(const Departure& departure)
  {
    forEachStanding([&](auto& observer) { observer.left(departure); });
    if (!of_departures_.empty())
      tell(departure);
  }

  /// What one thread has observed while several advance disks at the same time: the sums over disks, and what
  /// added observers are told of. Sums of a disk are its own.
  class Share
  {
  public:
    explicit Share(const Observers& observers)
        : of_contacts_(!observers.of_contacts_.empty()),
          of_flights_(!observers.of_flights_.empty()),
          contacts_(observers.species_)
    {
    }

    bool wantsFlights() const { return of_flights_; }
    void flew(const Flight& flight) { add(Notice(flight)); }
    void left(const Departure& departure)
    {
      departures_.push_back(departure);
      add(Notice(departure));
    }

    /// What follows belongs to an event of this disk, if it is not of the disk that it is about.
    void beginEvent(std::uint32_t slot) { event_slot_ = slot; }
    const std::vector<Departure>& departures() const { return departures_; }

    /// Takes what was observed after its own.
    void take(Share&& later);

    /// Takes contacts: `outcome(k)` for k < count.
    template <typename OutcomeAt>
    void take(std::size_t count, OutcomeAt&& outcome_at)
    {
      // A local copy stays in registers, because the compiler must assume that it may alias the outcomes.
      ContactCounts counts = counts_;
      for (std::size_t k = 0; k < count; ++k)
      {
        const ContactOutcome outcome = outcome_at(k);
        counts.takeOverlap(outcome.overlap);
        if (!outcome.closed)
          continue;
        counts.take(outcome);
        contacts_.take(outcome);
      }
      counts_ = counts;
      for (std::size_t k = 0; of_contacts_ && k < count; ++k)
        if (const ContactOutcome outcome = outcome_at(k); outcome.closed)
          add(Notice(outcome));
    }

  private:
    friend Observers;

    void add(Notice&& notice)
    {
      if (event_slot_)
      {
        // An event may lead to another at the same time, of a smaller slot: it is the later one.
        const bool follows = !notices_.empty() && notices_.back().time == notice.time;
        notice.event_slot = follows ? std::max(*event_slot_, notices_.back().event_slot) : *event_slot_;
      }
      notices_.push_back(std::move(notice));
    }

    std::optional<std::uint32_t> event_slot_;
    bool of_contacts_;
    bool of_flights_;
    ContactCounts counts_;
    SpeciesContacts contacts_;
    std::vector<Notice> notices_;
    std::vector<Departure> departures_;
  };

  /// Takes what a thread has observed. What added observers are told of waits for deliver().
  void take(Share&& share);

  /// The sums of all disks.
  struct DiskSums
  {
    std::vector<Trajectory> trajectories;
    BaseImpulses impulses;
    ContactTimes contact_times{false};
  };
  void copyTo(DiskSums& sums) const
  {
    sums.trajectories = trajectories().all();
    sums.impulses = impulses();
    sums.contact_times = contactTimes();
  }
  void restore(const DiskSums& sums)
  {
    trajectories().setAll(sums.trajectories);
    std::get<BaseImpulses>(standing_) = sums.impulses;
    std::get<ContactTimes>(standing_) = sums.contact_times;
  }

  /// The time of a disk's last contact is beside its sums.
  double contactTime(std::uint32_t slot) const { return contactTimes().of(slot); }
  void setContactTime(std::uint32_t slot, double time) { std::get<ContactTimes>(standing_).set(slot, time); }

  /// The sums of a disk that SIMD batches take along.
  RowSums rowSums(std::uint32_t slot) const
  {
    RowSums sums;
    trajectories().load(slot, sums);
    impulses().load(slot, sums);
    return sums;
  }
  void setRowSums(std::uint32_t slot, const RowSums& sums)
  {
    trajectories().store(slot, sums);
    std::get<BaseImpulses>(standing_).store(slot, sums);
  }

  void prefetchSums(std::uint32_t slot) const
  {
    trajectories().prefetchTrajectory(slot);
    impulses().prefetchSum(slot);
  }

  /// Adds an observer, which is told of what it wishes from now on. @return it
  template <typename Added>
  Added* add(std::unique_ptr<Added> observer)
  {
    Added* added = observer.get();
    added_.push_back(std::move(observer));
    sortByWishes();
    return added;
  }
  void remove(const Observer* observer);

  /// Calls `observer` after each collision. An empty function removes the observer.
  void observeCollisions(CollisionObserver observer);

  /// Whether notices of contacts or flights of independent disks are collected, for delivery in the order of
  /// time: they take memory.
  bool collects() const { return ordered_ && !(of_contacts_.empty() && of_flights_.empty()); }

  /// Delivers the collected notices. @pre no later contact or flight ends earlier
  void deliver();

  void reserve(std::size_t count);
  void entered(const Disk& disk);
  void compact(const Compaction& compaction);
  void restart(double time);
  void endBlock(double time);
  void endEpoch(double time);
  void endSegment(double time);
  void rebase(double length);

  /// Whether blocks of the mean series are recorded: always for a layer, whose disks move together.
  /// Independent disks need none, unless the scene requests an accuracy, or an observer blocks.
  bool keepsBlocks() const
  {
    return !ordered_ || blocks_wished_ || std::get<AccuracySeries>(standing_).kept();
  }

  /// @param block_time of the original blocks [s]
  MeanSeries meanSeries(double block_time) const;

  /// @throws StateError if the state is not of this number of slots
  void archive(StateArchive& state, std::size_t slots);

  ContactCounts& counts() { return std::get<ContactCounts>(standing_); }
  const ContactCounts& counts() const { return std::get<ContactCounts>(standing_); }
  const SpeciesContacts& speciesContacts() const { return std::get<SpeciesContacts>(standing_); }
  const ContactTimes& contactTimes() const { return std::get<ContactTimes>(standing_); }
  const BaseImpulses& impulses() const { return std::get<BaseImpulses>(standing_); }
  const SpeciesAverages& averages() const { return std::get<SpeciesAverages>(standing_); }
  /// Of a profile; empty for a sawtooth.
  FaceContacts faceContacts() const { return faces_ ? faces_->contacts() : FaceContacts(); }
  const EnergyWatch& energyWatch() const { return std::get<EnergyWatch>(standing_); }
  /// What the scene asks for, until `time`.
  std::vector<Observed> observed(double time) const;

  const std::vector<SpeciesBins>& bins() const { return bins_->ofSpecies(); }
  TrajectorySums& trajectories() { return std::get<TrajectorySums>(standing_); }
  const TrajectorySums& trajectories() const { return std::get<TrajectorySums>(standing_); }

private:
  template <typename Call>
  void forEachStanding(Call&& call)
  {
    std::apply([&](auto&... observers) { (call(observers), ...); }, standing_);
  }

  /// Of the added ones, too.
  template <typename Call>
  void forEach(Call&& call)
  {
    forEachStanding(call);
    for (const std::unique_ptr<Observer>& observer : added_)
      call(*observer);
  }

  [[gnu::noinline]] void tell(const ContactOutcome& outcome);
  [[gnu::noinline]] void take(const ContactOutcome& outcome, Share& share);
  [[gnu::noinline]] void tell(const Flight& flight, Share* share);
  [[gnu::noinline]] void tell(const Departure& departure);
  void deliver(const Notice& notice);
  void sortByWishes();

  const SystemState& system_;
  std::size_t species_;
  bool ordered_;  ///< whether disks are independent

  /// Those that read trajectories come before them: a compaction takes them away.
  std::tuple<ContactCounts, SpeciesContacts, BaseImpulses, ContactTimes, SpeciesAverages, AccuracySeries,
             EnergyWatch, TrajectorySums>
      standing_;

  std::vector<std::unique_ptr<Observer>> added_;
  std::vector<Observer*> of_contacts_;  ///< of the added ones: those who wish to be told of contacts
  std::vector<Observer*> of_flights_;
  std::vector<Observer*> of_departures_;
  bool blocks_wished_ = false;
  Notices notices_;
  const Bins* bins_;  ///< the first of the added, which are told of departures in the order of time
  std::vector<const Observable*> observables_;  ///< of the added, in the order of the scene
  const Observer* collision_report_ = nullptr;  ///< one of the added
  const FaceCounts* faces_ = nullptr;           ///< one of the added
};

}  // namespace ratchet_sieve
