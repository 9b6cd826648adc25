#include "state/observers.h"

#include <algorithm>

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

Observers::Observers(const SystemState& system)
    : system_(system), times_(system.plan().contact_times), averages_(system), accuracy_(system)
{
}

void Observers::added()
{
  impulses_.added();
  times_.added();
}

void Observers::keep(const std::vector<std::uint32_t>& kept, const std::vector<std::uint32_t>& left)
{
  averages_.forget(system_, left);
  accuracy_.forget(left);
  impulses_.keep(kept, left);
  times_.keep(kept);
}

void Observers::restartMeans()
{
  averages_.restart();
  accuracy_.restart();
  impulses_.restart();
}

void Observers::endBlockOfMeans(double time)
{
  if (system_.plan().pairs)
    averages_.endBlock(system_, time);
  accuracy_.endBlock(time);
}

MeanSeries Observers::meanSeries(double block_time) const
{
  MeanSeries series;
  series.species.resize(system_.scene().species.size());
  for (std::size_t s = 0; s < series.species.size(); ++s)
    series.species[s].velocity = averages_.blocks(s).blocks();
  accuracy_.addTo(series);
  series.block_time =
      block_time * static_cast<double>(std::max(averages_.blocks(0).blockLength(), accuracy_.blockLength()));
  return series;
}

void Observers::archive(StateArchive& state)
{
  state(counts_, impulses_, times_, averages_, accuracy_);
  const std::size_t count = system_.disks().size();
  if (!impulses_.fits(count) || !times_.fits(count))
    throw StateError("it is of another scene");
}

}  // namespace ratchet_sieve
