#pragma once

#include <cstdint>

#include "model/base_motion.h"
#include "search/contact_search.h"
#include "search/pair_search.h"

namespace ratchet_sieve
{

class SystemState;

/// Predicts the contacts of disks with each other and with the base, for one event loop or one thread of it.
/// Times are local to the epoch.
class ContactPrediction
{
public:
  /// @param system outlives this
  explicit ContactPrediction(const SystemState& system);

  /// To be called after the base's motion, the zero of time or the length of the epoch has changed.
  void renew();

  /// The base as of the last time that was asked for.
  BaseInstant& base() { return base_; }

  /// For contacts of a disk with others on its flight from `from` on.
  PairSearch pairsOf(std::uint32_t slot, double from) const { return {pairs_, slot, from}; }

  /// The disk's first event with the base, searched from `from` and only as far as needed to find all before
  /// `until`. At infinity if there is none before the base's motion changes, because everything is predicted
  /// anew then.
  BaseEvent nextBaseEvent(std::uint32_t slot, const Kinematics& from, double until);

private:
  const SystemState& system_;
  PairScene pairs_;
  ContactSearch search_;
  BaseInstant base_;
};

}  // namespace ratchet_sieve
