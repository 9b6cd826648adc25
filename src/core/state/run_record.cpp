#include "state/run_record.h"

namespace ratchet_sieve
{

CollisionRecord recordOf(const ContactOutcome& outcome, const MachineState& machine)
{
  CollisionRecord record;
  record.time = machine.epoch().start + outcome.time;
  record.kind = outcome.kind;
  record.i = machine.id(outcome.i);
  if (outcome.j != ContactOutcome::BASE)
    record.j = machine.id(outcome.j);
  record.normal_speed = -outcome.normal_velocity;
  record.normal_impulse = outcome.normal_impulse;
  record.tangential_impulse = outcome.tangential_impulse;
  return record;
}

RunRecord::RunRecord(const MachineState& machine)
    : machine_(machine), times_(machine.plan().contact_times), tally_(machine.scene().species)
{
}

void RunRecord::added()
{
  impulses_.added();
  times_.added();
}

void RunRecord::keep(const std::vector<std::uint32_t>& kept, const std::vector<std::uint32_t>& left)
{
  tally_.forget(machine_, left);
  impulses_.keep(kept, left);
  times_.keep(kept);
}

void RunRecord::restartMeans()
{
  tally_.restart();
  impulses_.restart();
}

void RunRecord::archive(StateArchive& state)
{
  state(counts_, impulses_, times_, tally_);
  const std::size_t count = machine_.disks().size();
  if (!impulses_.fits(count) || !times_.fits(count))
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
