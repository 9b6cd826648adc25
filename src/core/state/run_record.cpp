#include "state/run_record.h"

#include <algorithm>

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
    : machine_(machine),
      faces_(machine.shape()),
      times_(machine.plan().contact_times),
      tally_(machine.scene().species),
      accuracy_(machine)
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
  accuracy_.forget(left);
  impulses_.keep(kept, left);
  times_.keep(kept);
}

void RunRecord::restartMeans()
{
  tally_.restart();
  accuracy_.restart();
  impulses_.restart();
}

void RunRecord::endBlockOfMeans(double time)
{
  if (machine_.plan().pairs)
    tally_.endBlock(machine_, time);
  accuracy_.endBlock(time);
}

MeanSeries RunRecord::meanSeries(double block_time) const
{
  MeanSeries series;
  series.species.resize(machine_.scene().species.size());
  for (std::size_t s = 0; s < series.species.size(); ++s)
    series.species[s].velocity = tally_.blocks(s).blocks();
  accuracy_.addTo(series);
  series.block_time =
      block_time * static_cast<double>(std::max(tally_.blocks(0).blockLength(), accuracy_.blockLength()));
  return series;
}

void RunRecord::archive(StateArchive& state)
{
  state(counts_, faces_, impulses_, times_, tally_, accuracy_);
  const std::size_t count = machine_.disks().size();
  if (!impulses_.fits(count) || !times_.fits(count))
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
