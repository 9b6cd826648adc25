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
#include "state/observer.h"

namespace ratchet_sieve
{

/// A Flight with its disk.
struct KeptFlight
{
  Disk disk;
  double end;
  std::uint32_t slot;

  operator Flight() const { return {slot, disk, end}; }
};

/// Something that added observers are told of, kept until it is its turn: disks that are independent are not
/// simulated in the order of time. So what an observer adds up does not depend on the number of threads.
struct PendingReport
{
  explicit PendingReport(const ContactOutcome& outcome)
      : time(outcome.time), event_slot(outcome.i), what(outcome)
  {
  }
  explicit PendingReport(const Flight& flight)
      : time(flight.end), event_slot(flight.slot), what(KeptFlight{flight.disk, flight.end, flight.slot})
  {
  }
  explicit PendingReport(const Departure& departure)
      : time(departure.time), event_slot(departure.slot), what(departure)
  {
  }

  double time;               ///< local to the epoch [s]
  std::uint32_t event_slot;  ///< of the disk whose event it was: breaks ties
  std::variant<ContactOutcome, KeptFlight, Departure> what;
};

/// What one thread has observed while several advance disks at the same time: the sums over disks, and what
/// added observers are told of. Sums of a disk are its own.
class ThreadBuffer
{
public:
  /// @param contacts, flights whether added observers are told of them
  ThreadBuffer(std::size_t species, bool contacts, bool flights)
      : of_contacts_(contacts), of_flights_(flights), species_contacts_(species)
  {
  }

  bool wantsFlights() const { return of_flights_; }
  void flew(const Flight& flight) { add(PendingReport(flight)); }
  void left(const Departure& departure)
  {
    ++departures_;
    add(PendingReport(departure));
  }

  /// What follows belongs to an event of this disk, if it is not of the disk that it is about.
  void beginEvent(std::uint32_t slot) { event_slot_ = slot; }
  std::size_t departures() const { return departures_; }

  /// Takes what was observed after its own.
  void merge(ThreadBuffer&& later)
  {
    counts_.add(later.counts_);
    species_contacts_.add(later.species_contacts_);
    std::move(later.reports_.begin(), later.reports_.end(), std::back_inserter(reports_));
    departures_ += later.departures_;
  }

  /// Takes contacts: `outcome(k)` for k < count.
  template <typename OutcomeAt>
  void collided(std::size_t count, OutcomeAt&& outcome_at)
  {
    // A local copy stays in registers, because the compiler must assume that it may alias the outcomes.
    ContactCounts counts = counts_;
    for (std::size_t k = 0; k < count; ++k)
    {
      const ContactOutcome outcome = outcome_at(k);
      counts.addOverlap(outcome.overlap);
      if (!outcome.closed)
        continue;
      counts.collided(outcome);
      species_contacts_.collided(outcome);
    }
    counts_ = counts;
    for (std::size_t k = 0; of_contacts_ && k < count; ++k)
      if (const ContactOutcome outcome = outcome_at(k); outcome.closed)
        add(PendingReport(outcome));
  }

private:
  friend class Observers;

  void add(PendingReport&& report)
  {
    if (event_slot_)
    {
      // An event may lead to another at the same time, of a smaller slot: it is the later one.
      const bool follows = !reports_.empty() && reports_.back().time == report.time;
      report.event_slot = follows ? std::max(*event_slot_, reports_.back().event_slot) : *event_slot_;
    }
    reports_.push_back(std::move(report));
  }

  std::optional<std::uint32_t> event_slot_;
  bool of_contacts_;
  bool of_flights_;
  ContactCounts counts_;
  SpeciesContacts species_contacts_;
  std::vector<PendingReport> reports_;
  std::size_t departures_ = 0;
};

}  // namespace ratchet_sieve
