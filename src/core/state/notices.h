#pragma once

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "state/observer.h"

namespace ratchet_sieve
{

/// Something that added observers are told of, kept until it is its turn.
struct Notice
{
  /// A Flight with its disk.
  struct KeptFlight
  {
    Disk from;
    double end;
  };

  explicit Notice(const ContactOutcome& outcome) : time(outcome.time), slot(outcome.i), what(outcome) {}
  explicit Notice(const Flight& flight)
      : time(flight.end), slot(flight.slot), what(KeptFlight{flight.from, flight.end})
  {
  }
  explicit Notice(const Departure& departure) : time(departure.time), slot(departure.slot), what(departure) {}

  double time;  ///< local to the epoch [s]
  std::uint32_t slot;
  std::uint32_t event_slot = slot;  ///< of the disk whose event it was: breaks ties
  std::variant<ContactOutcome, KeptFlight, Departure> what;
};

/// Notices of disks that are not simulated in the order of time, for delivery in that order. So what an
/// observer adds up does not depend on the number of threads.
class Notices
{
public:
  void add(Notice&& notice) { waiting_.push_back(std::move(notice)); }

  /// Those of one thread. @pre those of one event slot come in the order of time
  void add(std::vector<Notice>&& more)
  {
    waiting_.insert(waiting_.end(), std::make_move_iterator(more.begin()),
                    std::make_move_iterator(more.end()));
    more.clear();
  }

  /// Hands over all, in the order of time. @pre no later notice has an earlier time
  template <typename Deliver>
  void flush(Deliver&& deliver)
  {
    if (waiting_.empty())
      return;
    std::stable_sort(waiting_.begin(), waiting_.end(),
                     [](const Notice& a, const Notice& b)
                     { return std::tie(a.time, a.event_slot) < std::tie(b.time, b.event_slot); });
    for (const Notice& notice : waiting_)
      deliver(notice);
    waiting_.clear();
  }

private:
  std::vector<Notice> waiting_;
};

}  // namespace ratchet_sieve
