#include "state/observers.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "state/flow_blocks.h"
#include "state/system_state.h"

namespace ratchet_sieve
{
namespace
{
/// Adds a disk to the bin into which it fell.
void count(const Departure& departure, SpeciesBins& bins)
{
  const bool left = departure.exit == Exit::LEFT_BIN;
  ++(left ? bins.left : bins.right);
  (left ? bins.left_mass : bins.right_mass) += departure.mass;
}
}  // namespace

/// The disks and their mass by place: in the machine, and in the bins at its ends. Of size classes, the
/// numbers alone.
class Bins final : public Observer
{
public:
  explicit Bins(const SystemState& system)
      : of_species(system.scene().species.size()),
        of_size_classes(system.sizeClasses().size()),
        system_(system)
  {
  }

  void entered(const Disk& disk, double /*time*/) override
  {
    ++of_species[disk.species].on_base;
    if (const std::size_t k = system_.sizeClassOf(disk); k < of_size_classes.size())
      ++of_size_classes[k].on_base;
  }
  void left(const Departure& departure) override
  {
    --of_species[departure.species].on_base;
    count(departure, of_species[departure.species]);
    const std::size_t k = system_.sizeClassOf(system_.disk(departure.slot));
    if (k == of_size_classes.size())
      return;
    --of_size_classes[k].on_base;
    ++(departure.exit == Exit::LEFT_BIN ? of_size_classes[k].left : of_size_classes[k].right);
  }

  /// @throws StateError if the state is of another number of species
  void archive(StateArchive& state) override
  {
    const std::size_t species = of_species.size();
    state(of_species);
    if (of_species.size() != species)
      throw StateError("it is of another scene");
  }

  std::vector<SpeciesBins> of_species;
  std::vector<SpeciesBins> of_size_classes;  ///< archived by the system

private:
  const SystemState& system_;
};

Observers::Observers(const SystemState& system)
    : system_(system),
      species_(system.scene().species.size()),
      ordered_(!system.plan().pairs),
      species_contacts_(species_),
      contact_times_(system.plan().contact_times),
      averages_(system),
      energy_watch_(system),
      trajectories_(system),
      bins_(add(std::make_unique<Bins>(system)))
{
  if (system.scene().feed.any() && system.scene().boundary != Boundary::PERIODIC)
    flow_ = add(std::make_unique<FlowBlocks>(system));
  for (const std::string& name : system.scene().observe)
    observables_.push_back(add(makeObservable(name, system)));
  if (system.shape().isProfile())
    faces_ = add(std::make_unique<FaceCounts>(system.shape()));
}

/// The sums of a disk change at once: no other thread has the disk.
void Observers::collided(const ContactOutcome& outcome, ThreadBuffer& share)
{
  share.collided(1, [&](std::size_t) { return outcome; });
  if (!outcome.closed)
    return;
  impulses_.collided(outcome);
  contact_times_.collided(outcome);
}

void Observers::deliverNow(const ContactOutcome& outcome)
{
  for (const std::unique_ptr<Observer>& observer : added_)
    observer->collided(outcome);
  if (!on_collision_)
    return;
  CollisionRecord record;
  record.time = system_.epoch().start + outcome.time;
  record.kind = outcome.kind;
  record.i = system_.id(outcome.i);
  if (outcome.j != ContactOutcome::BASE)
    record.j = system_.id(outcome.j);
  record.normal_speed = -outcome.normal_velocity;
  record.normal_impulse = outcome.normal_impulse;
  record.tangential_impulse = outcome.tangential_impulse;
  on_collision_(record);
}

void Observers::deliverNow(const Flight& flight)
{
  for (const std::unique_ptr<Observer>& observer : added_)
    observer->flew(flight);
}

void Observers::deliverNow(const Departure& departure)
{
  for (const std::unique_ptr<Observer>& observer : added_)
    observer->left(departure);
  const double time = system_.epoch().start + departure.time;
  if (kept_length_ > 0.0)
    exits_.emplace_back(time, departure);
  while (!exits_.empty() && exits_.front().first <= time - kept_length_)
    exits_.pop_front();
  if (!on_exit_)
    return;
  const Disk& disk = system_.disk(departure.slot);  // which stays as it was when it left
  on_exit_({time, system_.id(departure.slot), departure.species, disk.radius, departure.mass, departure.exit,
            disk.position.x()});
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

void Observers::merge(ThreadBuffer&& share)
{
  counts_.add(share.counts_);
  species_contacts_.add(share.species_contacts_);
  std::move(share.reports_.begin(), share.reports_.end(), std::back_inserter(pending_));
  share.reports_.clear();
}

void Observers::noteSubscriptions()
{
  subscriptions_ = on_collision_ ? unsigned{Observer::CONTACTS} : 0;
  for (const std::unique_ptr<Observer>& observer : added_)
    subscriptions_ |= observer->subscriptions();
}

ExitWindow Observers::exitWindow(double time, double not_before) const
{
  ExitWindow window{std::max({time - kept_length_, kept_from_, not_before}),
                    std::vector<SpeciesBins>(species_)};
  for (auto exit = exits_.rbegin(); exit != exits_.rend() && exit->first > window.start; ++exit)
    count(exit->second, window.bins[exit->second.species]);
  return window;
}

const std::vector<SpeciesBins>& Observers::bins() const
{
  return bins_->of_species;
}

std::vector<SpeciesBins>& Observers::sizeClassBins()
{
  return bins_->of_size_classes;
}

FlowSeries Observers::flowSeries(double start, double block_time) const
{
  return flow_ ? flow_->series(start, block_time) : FlowSeries();
}

std::vector<Observed> Observers::observed(double time, bool settled) const
{
  std::vector<Observed> observed;
  for (std::size_t k = 0; k < observables_.size(); ++k)
  {
    const std::unique_ptr<Observable> begun = makeObservable(system_.scene().observe[k], system_);
    begun->restart(time);
    observed.push_back((settled ? observables_[k] : begun.get())->observed(time));
  }
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
