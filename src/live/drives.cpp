#include "ratchet_sieve/live/drives.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{
namespace
{
/// A lag moves the base in so many steps per time constant: each step needs new predictions for all disks.
constexpr double STEPS_PER_TIME_CONSTANT = 20.0;
constexpr double SHORTEST_STEP = 1e-3;  // s

/// A lag ends at its goal when this share of the way is left.
constexpr double NEAR = 1e-3;

/// Linear in between; beyond an end the value there. @pre the table is not empty
double interpolated(const std::vector<std::pair<double, double>>& table, double at)
{
  const auto above = std::lower_bound(table.begin(), table.end(), at,
                                      [](const auto& point, double value) { return point.first < value; });
  if (above == table.begin())
    return above->second;
  const auto below = above - 1;
  if (above == table.end())
    return below->second;
  return below->second +
         (above->second - below->second) * (at - below->first) / (above->first - below->first);
}
}  // namespace

void Actuator::ask(double setpoint, double time)
{
  asked_ = setpoint;
  under_way_.emplace_back(time + settings_.dead_time, setpoint);
}

double Actuator::step() const
{
  return std::max(settings_.time_constant / STEPS_PER_TIME_CONSTANT, SHORTEST_STEP);
}

double Actuator::nextTime() const
{
  double next = std::numeric_limits<double>::infinity();
  if (!under_way_.empty())
    next = under_way_.front().first;
  if (position_ != goal_)
    next = std::min(next, position_time_ + step());
  return next;
}

void Actuator::lagTo(double time)
{
  // The exact solution, so that the steps do not change it.
  position_ = goal_ + (position_ - goal_) * std::exp((position_time_ - time) / settings_.time_constant);
  position_time_ = time;
  if (std::abs(position_ - goal_) <= near_)
    position_ = goal_;
}

void Actuator::advanceTo(double time)
{
  if (position_ != goal_)
    lagTo(time);
  while (!under_way_.empty() && under_way_.front().first <= time)
  {
    goal_ = under_way_.front().second;
    under_way_.pop_front();
    position_time_ = time;
    near_ = NEAR * std::abs(position_ - goal_);
    if (settings_.time_constant == 0.0)
      position_ = goal_;
  }
}

double Actuator::output(double frequency, const Interval& legal) const
{
  if (held_)
    return *held_;
  double value = position_;
  if (settings_.resolution > 0.0)
    value = std::round(value / settings_.resolution) * settings_.resolution;
  if (!settings_.over_frequency.empty())
    value *= interpolated(settings_.over_frequency, frequency);
  return std::clamp(value + settings_.offset, legal.min, legal.max);
}

Drives::Drives(const DriveParameters& settings, const BaseDefinition& base, double time)
{
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
    drives_.emplace_back(settings[indexOf(q.quantity)], base.*q.definition, time);
}

double Drives::nextTime() const
{
  double next = std::numeric_limits<double>::infinity();
  for (const Actuator& drive : drives_)
    next = std::min(next, drive.nextTime());
  return next;
}

void Drives::advanceTo(double time)
{
  for (Actuator& drive : drives_)
    if (drive.nextTime() <= time)
      drive.advanceTo(time);
}

double Drives::output(Quantity quantity) const
{
  const auto at = [this](Quantity q, double frequency)
  { return drives_[indexOf(q)].output(frequency, describe(q).legal); };
  return at(quantity, quantity == Quantity::AMPLITUDE ? at(Quantity::FREQUENCY, 0.0) : 0.0);
}

std::vector<std::string> Drives::faults(Quantity quantity)
{
  std::vector<std::string> names = {"none", "stuck"};
  if (quantity != Quantity::INCLINATION)
    names.emplace_back("off");
  return names;
}

void Drives::setFault(Quantity quantity, const std::string& fault, double applied)
{
  of(quantity).hold(fault == "none" ? std::nullopt : std::optional(fault == "off" ? 0.0 : applied));
}

}  // namespace ratchet_sieve
