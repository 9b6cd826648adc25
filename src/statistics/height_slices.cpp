#include "ratchet_sieve/statistics/height_slices.h"

#include <algorithm>
#include <cmath>

namespace ratchet_sieve
{

/// A flight as a function of the time since its start.
struct HeightSlices::Fall
{
  explicit Fall(const SeenFlight& flight) : height(flight.height[0]), weight(flight.weight)
  {
    const double rate = 1.0 / flight.duration;
    along = {flight.along[0], (flight.along[1] - flight.along[0]) * rate};
    // From both heights, so that flights that follow one another leave no gap between them.
    const double acceleration = (flight.upwards[1] - flight.upwards[0]) * rate;
    upwards = {(flight.height[1] - flight.height[0]) * rate - 0.5 * acceleration * flight.duration,
               acceleration};
  }

  double heightAt(double time) const { return height + (upwards.start + 0.5 * upwards.rate * time) * time; }

  /// When it reaches a height after `from`, moving in one direction until then.
  double timeAt(double wanted, double from, bool up) const
  {
    const double speed = upwards.at(from);
    const double way = wanted - heightAt(from);
    const double root = std::sqrt(std::max(0.0, speed * speed + 2.0 * upwards.rate * way));
    const double divisor = speed + (up ? root : -root);
    return divisor != 0.0 ? from + 2.0 * way / divisor : from;
  }

  double height;
  double weight;
  Linear along, upwards;
};

HeightSlices::Sums& HeightSlices::Sums::operator+=(const Sums& other)
{
  time += other.time;
  weight += other.weight;
  along += other.along;
  upwards += other.upwards;
  squared += other.squared;
  return *this;
}

double HeightSlices::Sums::variance() const
{
  return std::max(0.0, squared - (along * along + upwards * upwards) / weight) / time;
}

void HeightSlices::add(const SeenFlight& flight, std::size_t part)
{
  const Fall fall(flight);
  const double end = flight.duration;
  time_ += end;
  height_integral_ += end * (fall.height + end * (0.5 * fall.upwards.start + fall.upwards.rate * end / 6.0));
  const double turn = fall.upwards.rate != 0.0 ? -fall.upwards.start / fall.upwards.rate : 0.0;
  if (turn > 0.0 && turn < end)
  {
    addMonotone(fall, 0.0, turn, part);
    addMonotone(fall, turn, end, part);
  }
  else
    addMonotone(fall, 0.0, end, part);
}

/// Of the disks below the base line, too, the lowest slice.
std::size_t HeightSlices::sliceAt(double height) const
{
  return static_cast<std::size_t>(std::clamp(std::floor(height / height_), 0.0, static_cast<double>(MOST)));
}

void HeightSlices::addMonotone(const Fall& fall, double from, double to, std::size_t part)
{
  std::size_t slice = sliceAt(fall.heightAt(from));
  const std::size_t last = sliceAt(fall.heightAt(to));
  const bool up = slice < last;
  while (slice != last)
  {
    const double edge = height_ * static_cast<double>(up ? slice + 1 : slice);
    const double reached = std::clamp(fall.timeAt(edge, from, up), from, to);
    addWithin(fall, from, reached, slice, part);
    from = reached;
    slice = up ? slice + 1 : slice - 1;
  }
  addWithin(fall, from, to, last, part);
}

void HeightSlices::addWithin(const Fall& fall, double from, double to, std::size_t slice, std::size_t part)
{
  const double time = to - from;
  if (slice == MOST)
  {
    time_above_ += time;
    return;
  }
  if (count() <= slice)
    sums_.resize((slice + 1) * parts_);
  // Integrals of a velocity that changes at a constant rate, and of its square.
  const auto squared = [](double a, double b) { return (a * a + a * b + b * b) * (1.0 / 3.0); };
  const double along_from = fall.along.at(from), along_to = fall.along.at(to);
  const double up_from = fall.upwards.at(from), up_to = fall.upwards.at(to);
  const double weight = fall.weight * time;
  sums_[slice * parts_ + part] +=
      {time, weight, 0.5 * weight * (along_from + along_to), 0.5 * weight * (up_from + up_to),
       weight * (squared(along_from, along_to) + squared(up_from, up_to))};
}

}  // namespace ratchet_sieve
