#include "lane_run.h"

#include <algorithm>

namespace ratchet_sieve
{
namespace
{
CollisionKind collisionKind(double feature)
{
  switch (static_cast<std::int32_t>(feature))
  {
    case LANE_LEFT_SLOPE:
      return CollisionKind::LEFT_SLOPE;
    case LANE_RIGHT_SLOPE:
      return CollisionKind::RIGHT_SLOPE;
    default:
      return CollisionKind::APEX;
  }
}
}  // namespace

void LaneRun::takeAccount(std::size_t rows)
{
  outcome_.events += rows;
  for (std::size_t row = 0; row < rows; ++row)
  {
    outcome_.max_overlap = std::max(outcome_.max_overlap, batch_.overlap[row]);
    met_[species_[row]][static_cast<std::int32_t>(batch_.feature[row])] +=
        batch_.normal_velocity[row] < 0.0 ? 1 : 0;
  }
}

LaneRun::Outcome LaneRun::takeOutcome()
{
  outcome_.contacts.clear();
  for (Contacts& contacts : met_)
  {
    CollisionCounts counts;
    counts.right_slope = contacts[LANE_RIGHT_SLOPE];
    counts.left_slope = contacts[LANE_LEFT_SLOPE];
    counts.apex = contacts[LANE_APEX];
    outcome_.collisions.add(counts);
    outcome_.contacts.push_back(counts.total());
    contacts = {};
  }
  return std::exchange(outcome_, Outcome());
}

void LaneRun::record(const Machine& machine, std::size_t rows)
{
  for (std::size_t row = 0; row < rows; ++row)
  {
    if (!(batch_.normal_velocity[row] < 0.0))
      continue;
    CollisionRecord record;
    record.time = machine.epoch().start + batch_.due[row];
    record.kind = collisionKind(batch_.feature[row]);
    record.i = machine.number(ids_[row]);
    record.normal_speed = -batch_.normal_velocity[row];
    record.normal_impulse = batch_.normal_impulse[row];
    record.tangential_impulse = batch_.tangential_impulse[row];
    outcome_.records.push_back(record);
  }
}

}  // namespace ratchet_sieve
