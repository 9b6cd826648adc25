#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "state/contact_sums.h"
#include "state/disk_events.h"

namespace ratchet_sieve
{

/// Something that observers are told of, kept until it is its turn: disks that are independent are not
/// simulated in the order of time. So what an observer adds up does not depend on the number of threads.
struct PendingReport
{
  explicit PendingReport(const ContactOutcome& outcome)
      : time(outcome.time), event_slot(outcome.i), what(outcome)
  {
  }
  explicit PendingReport(const Flight& flight) : time(flight.end), event_slot(flight.slot), what(flight) {}
  explicit PendingReport(const Departure& departure)
      : time(departure.time), event_slot(departure.slot), what(departure)
  {
  }

  double time;               ///< local to the epoch [s]
  std::uint32_t event_slot;  ///< of the disk whose event it was: breaks ties
  std::variant<ContactOutcome, Flight, Departure> what;
};

/// What one thread has observed while several advance disks at the same time: sums over contacts, and what
/// observers are told of.
class ThreadBuffer
{
public:
  /// @param contacts, flights whether observers are told of them
  ThreadBuffer(std::size_t species, bool contacts, bool flights)
      : contacts(species), of_contacts_(contacts), of_flights_(flights)
  {
  }

  ContactSums contacts;
  std::vector<PendingReport> reports;
  std::size_t departures = 0;

  bool wantsFlights() const { return of_flights_; }
  void flew(const Flight& flight) { add(PendingReport(flight)); }
  void departed(const Departure& departure)
  {
    ++departures;
    add(PendingReport(departure));
  }

  /// What follows belongs to an event of this disk, if it is not of the disk that it is about.
  void beginEvent(std::uint32_t slot) { event_slot_ = slot; }

  /// Takes what was observed after its own.
  void merge(ThreadBuffer&& later)
  {
    contacts.add(later.contacts);
    std::move(later.reports.begin(), later.reports.end(), std::back_inserter(reports));
    departures += later.departures;
  }

  [[gnu::noinline]] void collided(const ContactOutcome& outcome)
  {
    collided(1, [&](std::size_t) { return outcome; });
  }

  /// Takes contacts: `outcome(k)` for k < count.
  template <typename OutcomeAt>
  void collided(std::size_t count, OutcomeAt&& outcome_at)
  {
    contacts.add(count, outcome_at);
    for (std::size_t k = 0; of_contacts_ && k < count; ++k)
      if (const ContactOutcome outcome = outcome_at(k); outcome.closed)
        add(PendingReport(outcome));
  }

private:
  void add(PendingReport&& report)
  {
    if (event_slot_)
    {
      // An event may lead to another at the same time, of a smaller slot: it is the later one.
      const bool follows = !reports.empty() && reports.back().time == report.time;
      report.event_slot = follows ? std::max(*event_slot_, reports.back().event_slot) : *event_slot_;
    }
    reports.push_back(std::move(report));
  }

  std::optional<std::uint32_t> event_slot_;
  bool of_contacts_;
  bool of_flights_;
};

}  // namespace ratchet_sieve
