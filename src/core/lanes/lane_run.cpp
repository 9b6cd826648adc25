#include "lanes/lane_run.h"

namespace ratchet_sieve
{

void LaneRun::takeOutcomes(const Machine& system, std::size_t rows)
{
  report_.events += rows;
  // A local copy stays in registers, because the compiler must assume that the columns may alias
  // report_.counts.
  ContactCounts counts = report_.counts;
  for (std::size_t row = 0; row < rows; ++row)
  {
    const ContactOutcome outcome = outcomeOf(batch_, row, slots_[row]);
    counts.take(outcome);
    report_.contacts[species_[row]] += outcome.closed ? 1 : 0;
  }
  report_.counts = counts;
  if (!system.record().collisionObserver())
    return;
  for (std::size_t row = 0; row < rows; ++row)
    if (const ContactOutcome outcome = outcomeOf(batch_, row, slots_[row]); outcome.closed)
      report_.records.push_back(recordOf(outcome, system.state()));
}

LaneRun::Report LaneRun::takeReport()
{
  return std::exchange(report_, Report());
}

}  // namespace ratchet_sieve
