#include "state/observers.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

#include "state/recent_exits.h"
#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// Tells a caller of some of what happens.
template <typename Caller>
class Report : public Observer
{
public:
  Report(const SystemState& system, Caller observer) : system_(system), observer_(std::move(observer)) {}

protected:
  const SystemState& system_;
  Caller observer_;
};

/// Tells a caller of each collision.
class CollisionReport final : public Report<CollisionObserver>
{
public:
  using Report::Report;
  unsigned subscriptions() const override { return CONTACTS; }
  void collided(const ContactOutcome& outcome) override
  {
    CollisionRecord record;
    record.time = system_.epoch().start + outcome.time;
    record.kind = outcome.kind;
    record.i = system_.id(outcome.i);
    if (outcome.j != ContactOutcome::BASE)
      record.j = system_.id(outcome.j);
    record.normal_speed = -outcome.normal_velocity;
    record.normal_impulse = outcome.normal_impulse;
    record.tangential_impulse = outcome.tangential_impulse;
    observer_(record);
  }
};

/// Tells a caller of each disk that leaves.
class ExitReport final : public Report<ExitObserver>
{
public:
  using Report::Report;
  unsigned subscriptions() const override { return DEPARTURES; }
  void left(const Departure& departure) override
  {
    const Disk& disk = system_.disk(departure.slot);  // which stays as it was when it left
    observer_({system_.epoch().start + departure.time, system_.id(departure.slot), departure.species,
               disk.radius, departure.mass, departure.exit, disk.position.x()});
  }
};
}  // namespace

Observers::Observers(const SystemState& system)
    : system_(system),
      species_(system.scene().species.size()),
      ordered_(!system.plan().pairs),
      species_contacts_(species_),
      contact_times_(system.plan().contact_times),
      averages_(system),
      energy_watch_(system),
      trajectories_(system),
      bins_(add(std::make_unique<Bins>(species_)))
{
  for (const std::string& name : system.scene().observe)
    observables_.push_back(add(makeObservable(name, system)));
  if (system.shape().isProfile())
    faces_ = add(std::make_unique<FaceCounts>(system.shape()));
}

/// The sums of a disk change at once: no other thread has the disk.
void Observers::collided(const ContactOutcome& outcome, Share& share)
{
  share.collided(1, [&](std::size_t) { return outcome; });
  if (!outcome.closed)
    return;
  impulses_.collided(outcome);
  contact_times_.collided(outcome);
}

template <typename What>
void Observers::tell(const What& what)
{
  if (ordered_)
    pending_.emplace_back(what);
  else
    deliverNow(what);
}

template void Observers::tell(const ContactOutcome& outcome);
template void Observers::tell(const Flight& flight);
template void Observers::tell(const Departure& departure);

void Observers::deliverNow(const ContactOutcome& outcome)
{
  for (Observer* observer : of_contacts_)
    observer->collided(outcome);
}

void Observers::deliverNow(const Flight& flight)
{
  for (Observer* observer : of_flights_)
    observer->flew(flight);
}

void Observers::deliverNow(const Departure& departure)
{
  for (Observer* observer : of_departures_)
    observer->left(departure);
}

void Observers::deliver()
{
  std::stable_sort(pending_.begin(), pending_.end(),
                   [](const PendingReport& a, const PendingReport& b)
                   { return std::tie(a.time, a.event_slot) < std::tie(b.time, b.event_slot); });
  for (const PendingReport& report : pending_)
    std::visit([this](const auto& what) { deliverNow(what); }, report.what);
  pending_.clear();
}

void Observers::merge(Share&& share)
{
  counts_.add(share.counts_);
  species_contacts_.add(share.species_contacts_);
  std::move(share.reports_.begin(), share.reports_.end(), std::back_inserter(pending_));
  share.reports_.clear();
  for (const Departure& departure : share.departures_)
    forEachStanding([&](auto& observer) { observer.left(departure); });
}

void Observers::remove(const Observer* observer)
{
  added_.erase(std::remove_if(added_.begin(), added_.end(),
                              [=](const std::unique_ptr<Observer>& one) { return one.get() == observer; }),
               added_.end());
  sortBySubscription();
}

void Observers::sortBySubscription()
{
  const auto subscribers = [this](Observer::Subscription subscription)
  {
    std::vector<Observer*> found;
    for (const std::unique_ptr<Observer>& observer : added_)
      if ((observer->subscriptions() & subscription) != 0)
        found.push_back(observer.get());
    return found;
  };
  of_contacts_ = subscribers(Observer::CONTACTS);
  of_flights_ = subscribers(Observer::FLIGHTS);
  of_departures_ = subscribers(Observer::DEPARTURES);
  blocks_wanted_ = !subscribers(Observer::BLOCKS).empty();
}

void Observers::observeCollisions(CollisionObserver observer)
{
  remove(collision_report_);
  collision_report_ =
      observer ? add(std::make_unique<CollisionReport>(system_, std::move(observer))) : nullptr;
}

void Observers::observeExits(ExitObserver observer)
{
  remove(exit_report_);
  exit_report_ = observer ? add(std::make_unique<ExitReport>(system_, std::move(observer))) : nullptr;
}

void Observers::keepExits(double length, double time)
{
  remove(recent_exits_);
  recent_exits_ = add(std::make_unique<RecentExits>(system_, length, time));
}

ExitWindow Observers::exitWindow(double time, double not_before) const
{
  if (recent_exits_ == nullptr)
    return {time, std::vector<SpeciesBins>(species_)};
  return recent_exits_->until(time, not_before);
}

std::vector<Observed> Observers::observed(double time) const
{
  std::vector<Observed> observed;
  for (const Observable* observable : observables_)
    observed.push_back(observable->observed(time));
  return observed;
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
