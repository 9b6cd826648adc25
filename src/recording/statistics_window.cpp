#include "ratchet_sieve/recording/statistics_window.h"

#include <utility>

namespace ratchet_sieve
{

void StatisticsWindow::take(const PeriodRecord& period)
{
  if (!ended_)
  {
    ended_ = period;
    return;
  }
  ended_->end = period.end;
  ended_->collisions.add(period.collisions);
  ended_->duration += period.duration;
  for (std::size_t i = 0; i < period.temperatures.size(); ++i)
    ended_->temperatures[i].add(period.temperatures[i]);
}

void StatisticsWindow::restart(const Simulation& simulation)
{
  *this = StatisticsWindow();
  moveTo(simulation);
}

void StatisticsWindow::moveTo(const Simulation& simulation)
{
  const double now = simulation.time();
  const CollisionCounts& collisions = simulation.collisions();
  if (!last_time_)
  {
    last_time_ = shown_.start = shown_.end = now;
    granular_temperatures_.resize(simulation.scene().species.size());
  }
  if (ended_)
  {
    shown_ = std::move(*std::exchange(ended_, std::nullopt));
    for (std::size_t i = 0; i < shown_.temperatures.size(); ++i)
      granular_temperatures_[i] = shown_.temperatures[i].mean();
  }
  else if (!simulation.swings())
  {
    if (now > *last_time_)
      shown_ = {*last_time_, now, now - *last_time_, collisions.since(last_collisions_), {}};
    granular_temperatures_ = simulation.granularTemperatures();
  }
  last_time_ = now;
  last_collisions_ = collisions;
}

CollisionRates StatisticsWindow::collisionRates() const
{
  const auto rate = [this](std::uint64_t count)
  { return shown_.duration > 0.0 ? static_cast<double>(count) / shown_.duration : 0.0; };
  const CollisionCounts& counts = shown_.collisions;
  return {rate(counts.disk_disk), rate(counts.left_slope), rate(counts.right_slope),
          rate(counts.apex),      rate(counts.wall),       rate(counts.level)};
}

}  // namespace ratchet_sieve
