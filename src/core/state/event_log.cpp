#include "state/event_log.h"

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
  void departed(const Departure& departure) override
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

/// Counts contacts with each face and corner of a profile. A sawtooth needs none: its kinds of contacts say
/// it.
class FaceCounts final : public Observer
{
public:
  explicit FaceCounts(const BaseShape& shape)
  {
    contacts_.face_contacts.resize(shape.faces().size());
    contacts_.corner_contacts.resize(shape.faces().size());
  }

  unsigned subscriptions() const override { return CONTACTS; }

  void collided(const ContactOutcome& outcome) override
  {
    const auto index = static_cast<std::size_t>(outcome.feature.index());
    if (outcome.feature.kind() == BaseFeatureKind::FACE)
      ++contacts_.face_contacts[index];
    else if (outcome.kind == CollisionKind::APEX)
      ++contacts_.corner_contacts[index];
  }

  const FaceContacts& contacts() const { return contacts_; }

  /// @throws StateError if the state is of another profile
  void archive(StateArchive& state) override
  {
    const std::size_t faces = contacts_.face_contacts.size();
    state(contacts_);
    if (contacts_.face_contacts.size() != faces || contacts_.corner_contacts.size() != faces)
      throw StateError("it is of another scene");
  }

private:
  FaceContacts contacts_;
};

EventLog::EventLog(const SystemState& system)
    : system_(system), ordered_(!system.plan().pairs), bins_(add(std::make_unique<Bins>(system)))
{
  if (system.scene().feed.any() && system.scene().boundary != Boundary::PERIODIC)
    flow_ = add(std::make_unique<FlowBlocks>(system));
  for (const std::string& name : system.scene().observe)
    observables_.push_back(add(makeObservable(name, system)));
  if (system.shape().isProfile())
    faces_ = add(std::make_unique<FaceCounts>(system.shape()));
}

EventLog::~EventLog() = default;

void EventLog::deliverNow(const ContactOutcome& outcome)
{
  for (const auto& observer : observers_)
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

void EventLog::deliverNow(const Flight& flight)
{
  for (const auto& observer : observers_)
    observer->flew(flight);
}

void EventLog::deliverNow(const Departure& departure)
{
  for (const auto& observer : observers_)
    observer->departed(departure);
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

void EventLog::deliver()
{
  std::stable_sort(pending_.begin(), pending_.end(),
                   [](const PendingReport& a, const PendingReport& b)
                   { return std::tie(a.time, a.event_slot) < std::tie(b.time, b.event_slot); });
  for (const PendingReport& report : pending_)
    std::visit([this](const auto& what) { deliverNow(what); }, report.what);
  pending_.clear();
}

void EventLog::take(std::vector<PendingReport>&& reports)
{
  std::move(reports.begin(), reports.end(), std::back_inserter(pending_));
}

void EventLog::noteSubscriptions()
{
  subscriptions_ = on_collision_ ? unsigned{Observer::CONTACTS} : 0;
  for (const auto& observer : observers_)
    subscriptions_ |= observer->subscriptions();
}

ExitWindow EventLog::exitWindow(double time, double not_before) const
{
  ExitWindow window{std::max({time - kept_length_, kept_from_, not_before}),
                    std::vector<SpeciesBins>(bins().size())};
  for (auto exit = exits_.rbegin(); exit != exits_.rend() && exit->first > window.start; ++exit)
    count(exit->second, window.bins[exit->second.species]);
  return window;
}

const std::vector<SpeciesBins>& EventLog::bins() const
{
  return bins_->of_species;
}

std::vector<SpeciesBins>& EventLog::sizeClassBins()
{
  return bins_->of_size_classes;
}

FlowSeries EventLog::flowSeries(double start, double block_time) const
{
  return flow_ ? flow_->series(start, block_time) : FlowSeries();
}

std::vector<Observed> EventLog::observed(double time, bool settled) const
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

FaceContacts EventLog::faceContacts() const
{
  return faces_ != nullptr ? faces_->contacts() : FaceContacts();
}

void EventLog::keep(const std::vector<std::uint32_t>& slots)
{
  for (const auto& observer : observers_)
    if (std::vector<double>* numbers = observer->perSlot())
      keepSlots(*numbers, slots);
}

void EventLog::archive(StateArchive& state, std::size_t slots)
{
  for (const auto& observer : observers_)
  {
    if (std::vector<double>* numbers = observer->perSlot())
    {
      state(*numbers);
      if (numbers->size() != slots)
        throw StateError("it is of another scene");
    }
    observer->archive(state);
  }
}

}  // namespace ratchet_sieve
