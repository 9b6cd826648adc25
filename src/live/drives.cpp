#include "ratchet_sieve/live/drives.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace ratchet_sieve
{
namespace
{
/// A lag moves the base in so many steps per time constant: each step needs new predictions for all disks.
constexpr double STEPS_PER_TIME_CONSTANT = 20.0;
constexpr double SHORTEST_STEP = 1e-3;  // s

/// The time constants after which the drive is at its goal: 0.1 % of the way is left.
constexpr double LENGTH_OF_LAG = 7.0;

/// Linear in between; beyond an end the value there. @pre the table is not empty
double interpolated(const std::map<double, double>& table, double at)
{
  const auto above = table.lower_bound(at);
  if (above == table.begin())
    return above->second;
  const auto below = std::prev(above);
  if (above == table.end())
    return below->second;
  return below->second +
         (above->second - below->second) * (at - below->first) / (above->first - below->first);
}
}  // namespace

Drives::Drives(const DriveParameters& settings, const BaseDefinition& base, double time)
{
  for (const CommandedQuantity& q : COMMANDED_QUANTITIES)
  {
    const DriveSettings& of = settings[indexOf(q.quantity)];
    const double at = base.*q.definition;
    drives_.push_back({of, at, {of.time_constant, time, at, at}});
  }
}

void Drives::ask(Quantity quantity, double setpoint, double time)
{
  Drive& drive = drives_[indexOf(quantity)];
  drive.asked = setpoint;
  drive.under_way.emplace_back(time + drive.settings.dead_time, setpoint);
}

double Drives::nextTime() const
{
  double next = std::numeric_limits<double>::infinity();
  for (const Drive& drive : drives_)
  {
    if (!drive.under_way.empty())
      next = std::min(next, drive.under_way.front().first);
    const Lag& lag = drive.lag;
    if (lag.output != lag.input)
      next = std::min(next, lag.time + std::max(lag.time_constant / STEPS_PER_TIME_CONSTANT, SHORTEST_STEP));
  }
  return next;
}

void Drives::advanceTo(double time)
{
  for (auto& [settings, asked, lag, settled_at, under_way, held] : drives_)
  {
    lag.advanceTo(time);
    for (; !under_way.empty() && under_way.front().first <= time; under_way.pop_front())
    {
      lag.input = under_way.front().second;
      settled_at = time + LENGTH_OF_LAG * lag.time_constant;
    }
    if (time >= settled_at)
      lag.output = lag.input;
  }
}

double Drives::output(Quantity quantity) const
{
  const Drive& drive = drives_[indexOf(quantity)];
  if (drive.held)
    return *drive.held;
  const DriveSettings& settings = drive.settings;
  double value = inSteps(drive.lag.output, settings.resolution);
  if (!settings.over_frequency.empty())
    value *= interpolated(settings.over_frequency, output(Quantity::FREQUENCY));
  const Interval& legal = describe(quantity).legal;
  return std::clamp(value + settings.offset, legal.min, legal.max);
}

std::vector<std::string> Drives::faults(Quantity quantity)
{
  if (quantity == Quantity::INCLINATION)
    return {"none", "stuck"};
  return {"none", "stuck", "off"};
}

void Drives::setFault(Quantity quantity, const std::string& fault, double applied)
{
  drives_[indexOf(quantity)].held =
      fault == "none" ? std::nullopt : std::optional(fault == "off" ? 0.0 : applied);
}

}  // namespace ratchet_sieve
