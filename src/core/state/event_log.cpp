#include "state/event_log.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "state/system_state.h"

namespace ratchet_sieve
{
EventLog::EventLog(const SystemState& system)
    : system_(system), ordered_(!system.plan().pairs), species_(system.scene().species.size())
{
}

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
  if (!on_exit_)
    return;
  const double time = system_.epoch().start + departure.time;
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
