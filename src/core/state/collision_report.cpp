#include "state/collision_report.h"

#include "state/system_state.h"

namespace ratchet_sieve
{

CollisionRecord recordOf(const ContactOutcome& outcome, const SystemState& system)
{
  CollisionRecord record;
  record.time = system.epoch().start + outcome.time;
  record.kind = outcome.kind;
  record.i = system.id(outcome.i);
  if (outcome.j != ContactOutcome::BASE)
    record.j = system.id(outcome.j);
  record.normal_speed = -outcome.normal_velocity;
  record.normal_impulse = outcome.normal_impulse;
  record.tangential_impulse = outcome.tangential_impulse;
  return record;
}

}  // namespace ratchet_sieve
