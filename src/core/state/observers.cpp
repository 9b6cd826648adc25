#include "state/observers.h"

#include <algorithm>
#include <iterator>

#include "state/collision_report.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

Observers::Observers(const SystemState& system)
    : system_(system),
      species_(system.scene().species.size()),
      ordered_(!system.plan().pairs),
      standing_(ContactCounts(), SpeciesContacts(species_), BaseImpulses(),
                ContactTimes(system.plan().contact_times), SpeciesAverages(system), AccuracySeries(system),
                EnergyWatch(system), TrajectorySums(system)),
      bins_(add(std::make_unique<Bins>(system)))
{
  for (const std::string& name : system.scene().observe)
    observables_.push_back(add(makeObservable(name, system)));
  if (system.shape().isProfile())
    faces_ = static_cast<FaceCounts*>(add(std::make_unique<FaceCounts>(system.shape())));
}

void Observers::tell(const ContactOutcome& outcome)
{
  if (ordered_)
    return notices_.add(Notice(outcome));
  for (Observer* observer : of_contacts_)
    observer->take(outcome);
}

/// The sums of a disk change at once: no other thread has the disk.
void Observers::take(const ContactOutcome& outcome, Share& share)
{
  share.take(1, [&](std::size_t) { return outcome; });
  if (!outcome.closed)
    return;
  std::get<BaseImpulses>(standing_).take(outcome);
  std::get<ContactTimes>(standing_).take(outcome);
}

void Observers::tell(const Flight& flight, Share* share)
{
  if (share != nullptr)
    return share->flew(flight);
  if (ordered_)
    return notices_.add(Notice(flight));
  for (Observer* observer : of_flights_)
    observer->flew(flight);
}

void Observers::tell(const Departure& departure)
{
  if (ordered_)
    return notices_.add(Notice(departure));
  for (Observer* observer : of_departures_)
    observer->left(departure);
}

void Observers::deliver(const Notice& notice)
{
  if (const auto* outcome = std::get_if<ContactOutcome>(&notice.what))
    for (Observer* observer : of_contacts_)
      observer->take(*outcome);
  else if (const auto* flight = std::get_if<Notice::KeptFlight>(&notice.what))
    for (Observer* observer : of_flights_)
      observer->flew({notice.slot, flight->from, flight->end});
  else
    for (Observer* observer : of_departures_)
      observer->left(std::get<Departure>(notice.what));
}

void Observers::deliver()
{
  notices_.flush([this](const Notice& notice) { deliver(notice); });
}

void Observers::Share::take(Share&& later)
{
  counts_.add(later.counts_);
  contacts_.add(later.contacts_);
  std::move(later.notices_.begin(), later.notices_.end(), std::back_inserter(notices_));
  std::move(later.departures_.begin(), later.departures_.end(), std::back_inserter(departures_));
}

void Observers::take(Share&& share)
{
  counts().add(share.counts_);
  std::get<SpeciesContacts>(standing_).add(share.contacts_);
  notices_.add(std::move(share.notices_));
  for (const Departure& departure : share.departures_)
    forEachStanding([&](auto& observer) { observer.left(departure); });
}

void Observers::remove(const Observer* observer)
{
  added_.erase(std::remove_if(added_.begin(), added_.end(),
                              [=](const std::unique_ptr<Observer>& one) { return one.get() == observer; }),
               added_.end());
  sortByWishes();
}

void Observers::sortByWishes()
{
  of_contacts_.clear();
  of_flights_.clear();
  of_departures_.clear();
  blocks_wished_ = false;
  for (const std::unique_ptr<Observer>& observer : added_)
  {
    const Observer::Wishes wishes = observer->wishes();
    if (wishes.contacts)
      of_contacts_.push_back(observer.get());
    if (wishes.flights)
      of_flights_.push_back(observer.get());
    if (wishes.departures)
      of_departures_.push_back(observer.get());
    blocks_wished_ = blocks_wished_ || wishes.blocks;
  }
}

void Observers::observeCollisions(CollisionObserver observer)
{
  remove(collision_report_);
  collision_report_ =
      observer ? add(std::make_unique<CollisionReport>(system_, std::move(observer))) : nullptr;
}

void Observers::reserve(std::size_t count)
{
  forEach([=](Observer& observer) { observer.reserve(count); });
}

void Observers::entered(const Disk& disk)
{
  forEach([&](Observer& observer) { observer.entered(disk); });
}

void Observers::compact(const Compaction& compaction)
{
  forEach([&](Observer& observer) { observer.compact(compaction); });
}

void Observers::restart(double time)
{
  forEach([=](Observer& observer) { observer.restart(time); });
}

void Observers::endBlock(double time)
{
  forEach([=](Observer& observer) { observer.endBlock(time); });
}

void Observers::endEpoch(double time)
{
  forEach([=](Observer& observer) { observer.endEpoch(time); });
}

void Observers::endSegment(double time)
{
  deliver();
  forEach([=](Observer& observer) { observer.endSegment(time); });
}

void Observers::rebase(double length)
{
  deliver();
  forEach([=](Observer& observer) { observer.rebase(length); });
}

std::vector<Observed> Observers::observed(double time) const
{
  std::vector<Observed> observed;
  for (const Observable* observable : observables_)
    observed.push_back(observable->observed(time));
  return observed;
}

MeanSeries Observers::meanSeries(double block_time) const
{
  const auto& accuracy = std::get<AccuracySeries>(standing_);
  MeanSeries series;
  series.species.resize(species_);
  for (std::size_t s = 0; s < series.species.size(); ++s)
    series.species[s].velocity = averages().blocks(s).blocks();
  accuracy.addTo(series);
  series.block_time =
      block_time * static_cast<double>(std::max(averages().blocks(0).blockLength(), accuracy.blockLength()));
  return series;
}

void Observers::archive(StateArchive& state, std::size_t slots)
{
  forEach(
      [&](Observer& observer)
      {
        observer.archive(state);
        if (!observer.fits(slots))
          throw StateError("it is of another scene");
      });
}

}  // namespace ratchet_sieve
