#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <vector>

#include "ratchet_sieve/core/segregation.h"
#include "state/bins.h"
#include "state/observer.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Keeps the disks that left lately. Times are the run's.
class RecentExits final : public Observer
{
public:
  /// @param length for which an exit is kept [s] @param start the present time [s]
  RecentExits(const SystemState& system, double length, double start)
      : system_(system), length_(length), start_(start)
  {
  }

  unsigned subscriptions() const override { return DEPARTURES; }
  void left(const Departure& departure) override
  {
    const double time = system_.epoch().start + departure.time;
    exits_.push_back({time, departure});
    while (exits_.front().time <= time - length_)
      exits_.pop_front();
  }

  /// What left after `not_before`, as far as it is kept, until `now`.
  ExitWindow until(double now, double not_before) const
  {
    ExitWindow window{std::max({now - length_, start_, not_before}), {}};
    window.bins.resize(system_.scene().species.size());
    for (auto exit = exits_.rbegin(); exit != exits_.rend() && exit->time > window.start; ++exit)
      count(exit->departure, window.bins);
    return window;
  }

private:
  struct Recent
  {
    double time;
    Departure departure;
  };

  const SystemState& system_;
  double length_;
  double start_;
  std::deque<Recent> exits_;  ///< in the order of time
};

}  // namespace ratchet_sieve
