#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>

#include "ratchet_sieve/core/resolution.h"
#include "search/contact_search.h"
#include "search/pair_search.h"
#include "state/system_state.h"

namespace ratchet_sieve
{

/// Predicts the contacts of disks with each other and with the base, for one event loop or one thread of it.
/// It changes nothing of the system. Times are local to the epoch.
class ContactPrediction
{
public:
  /// @param system outlives this
  explicit ContactPrediction(const SystemState& system)
      : system_(system),
        pairs_{system.disks(), system.motion(), system.shape().width(), resolution()},
        search_(system.shape(), system.motion(), system.scene().gravity, resolution()),
        base_(system.motion())
  {
  }

  /// To be called after the base's motion, the zero of time or the length of the epoch has changed.
  void renew()
  {
    pairs_.time_resolution = resolution();
    search_.setTimeResolution(resolution());
    base_.forget();
  }

  /// The base as of the last time that was asked for.
  BaseInstant& base() { return base_; }

  /// For contacts of a disk with others on its flight from `from` on.
  PairSearch pairsOf(std::uint32_t slot, double from) const { return {pairs_, slot, from}; }

  /// The disk's first event with the base, searched from `from` and only as far as needed to find all before
  /// `until`. At infinity if there is none before the base's motion changes, because everything is predicted
  /// anew then.
  BaseEvent nextBaseEvent(std::uint32_t slot, const Kinematics& from, double until)
  {
    // Without gravity there may be no event for very long; one epoch at a time is enough.
    double end = std::min(until, from.time + system_.epoch().length);
    const auto change = system_.motion().nextChange();
    if (change)
      end = std::min(end, *change);
    BaseEvent event = search_.find(system_.disk(slot), from, end, base_);
    if (!event.feature && change && event.time >= *change)
      event.time = std::numeric_limits<double>::infinity();
    return event;
  }

private:
  double resolution() const { return timeResolution(system_.epoch().length); }

  const SystemState& system_;
  PairScene pairs_;
  ContactSearch search_;
  BaseInstant base_;
};

}  // namespace ratchet_sieve
