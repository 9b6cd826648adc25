#pragma once

#include <utility>

#include "ratchet_sieve/core/observation.h"
#include "state/observer.h"

namespace ratchet_sieve
{

class SystemState;

/// A contact as a record for callers.
CollisionRecord recordOf(const ContactOutcome& outcome, const SystemState& system);

/// Tells a caller of each collision.
class CollisionReport final : public Observer
{
public:
  /// @param system outlives this
  CollisionReport(const SystemState& system, CollisionObserver observer)
      : system_(system), observer_(std::move(observer))
  {
  }

  Wishes wishes() const override
  {
    Wishes wishes;
    wishes.contacts = true;
    return wishes;
  }
  void take(const ContactOutcome& outcome) override { observer_(recordOf(outcome, system_)); }

private:
  const SystemState& system_;
  CollisionObserver observer_;
};

}  // namespace ratchet_sieve
