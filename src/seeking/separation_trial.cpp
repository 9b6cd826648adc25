#include "ratchet_sieve/seeking/separation_trial.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ratchet_sieve
{
namespace
{
/// Tolerance within which the base has reached its setpoint [rad, Hz, m]: far finer than setpoints are given,
/// or a sensor of a real feeder resolves.
constexpr double REACHED = 1e-6;

bool near(double one, double other)
{
  return std::abs(one - other) <= REACHED;
}

/// Whether time or a count has decreased: the sieve was reset or replaced.
bool isBefore(const BinFrame& frame, const BinFrame& last)
{
  if (frame.time < last.time || frame.bins.size() != last.bins.size())
    return true;
  for (std::size_t k = 0; k < frame.bins.size(); ++k)
    if (frame.bins[k].left < last.bins[k].left || frame.bins[k].right < last.bins[k].right)
      return true;
  return false;
}
}  // namespace

void SeparationTrial::begin(double inclination)
{
  const bool same = inclination == inclination_;
  inclination_ = inclination;
  followed_ = followed_ && same;
  if (!same)
    standing_since_.reset();
  first_ = same && standing_since_ ? end_ : std::nullopt;
  end_.reset();
  result_.reset();
  forgetStatistics();
}

void SeparationTrial::forgetStatistics()
{
  temperatures_.clear();
  paces_ = 0.0;
  paced_ = 0;
}

void SeparationTrial::interrupt()
{
  ++interruptions_;
  followed_ = false;
  base_time_.reset();
  standing_since_.reset();
  last_.reset();
  waiting_.reset();
  end_.reset();
  begin(inclination_);
}

bool SeparationTrial::stands(const DriveState& base) const
{
  return near(base.inclination, inclination_) && near(base.commanded_inclination, inclination_) &&
         near(base.frequency, base.commanded_frequency) && near(base.amplitude, base.commanded_amplitude);
}

void SeparationTrial::take(const BaseFrame& frame)
{
  if (base_time_ && frame.time < *base_time_)
    interrupt();
  base_time_ = frame.time;
  followed_ = near(frame.base.commanded_inclination, inclination_);
  if (!stands(frame.base))
  {
    standing_since_.reset();
    first_.reset();
    forgetStatistics();
  }
  else if (!standing_since_)
    standing_since_ = frame.time;
  if (waiting_ && waiting_->time <= frame.time)
    count(*std::exchange(waiting_, std::nullopt));
}

void SeparationTrial::take(const BinFrame& frame)
{
  if (last_ && isBefore(frame, *last_))
    interrupt();
  last_ = frame;
  if (base_time_ && frame.time <= *base_time_)
    count(frame);
  else if (!waiting_)
    waiting_ = frame;
}

void SeparationTrial::take(const StatisticsFrame& frame)
{
  if (!first_ || result_ || frame.time <= first_->time)
    return;
  temperatures_.resize(frame.species.size());
  for (std::size_t k = 0; k < temperatures_.size(); ++k)
    if (const auto& temperature = frame.species[k].granular_temperature)
      temperatures_[k].add(*temperature);
  if (frame.real_time_factor <= 0.0)
    return;
  paces_ += 1.0 / frame.real_time_factor;
  ++paced_;
}

void SeparationTrial::count(const BinFrame& frame)
{
  if (!standing_since_ || result_)
    return;
  if (!first_)
  {
    if (frame.time >= *standing_since_ + options_.dwell)
      first_ = frame;
    return;
  }
  Separation separation = since(*first_, frame);
  if (!isOver(separation))
    return;
  result_ = std::move(separation);
  end_ = frame;
}

/// A window in which no disk left has no result, however long it is.
bool SeparationTrial::isOver(const Separation& separation) const
{
  const double duration = separation.end - separation.begin;
  if (duration < options_.window)
    return false;
  const auto& bins = separation.bins;
  if (std::all_of(bins.begin(), bins.end(),
                  [this](const SpeciesBins& b) { return b.counted() >= options_.least_disks; }))
    return true;
  return duration >= options_.longest_window &&
         std::any_of(bins.begin(), bins.end(), [](const SpeciesBins& b) { return b.counted() > 0; });
}

Separation SeparationTrial::since(const BinFrame& first, const BinFrame& last) const
{
  Separation separation;
  separation.inclination = inclination_;
  separation.begin = first.time;
  separation.end = last.time;
  separation.duration = last.time - first.time;
  separation.species = last.species;
  separation.bins = last.bins;
  for (std::size_t k = 0; k < separation.bins.size(); ++k)
  {
    separation.bins[k].left -= first.bins[k].left;
    separation.bins[k].right -= first.bins[k].right;
    separation.bins[k].left_mass -= first.bins[k].left_mass;
    separation.bins[k].right_mass -= first.bins[k].right_mass;
  }
  for (const TemperatureSum& temperature : temperatures_)
    separation.granular_temperature.push_back(temperature.mean().value_or(0.0));
  separation.real_time_factor = paced_ > 0 ? paced_ / paces_ : 0.0;
  return separation;
}

}  // namespace ratchet_sieve
