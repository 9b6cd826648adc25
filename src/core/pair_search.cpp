#include "ratchet_sieve/core/pair_search.h"

#include <algorithm>

#include "ratchet_sieve/core/quadratic.h"
#include "ratchet_sieve/core/resolution.h"

namespace ratchet_sieve
{
namespace
{
/// Steps after which a search across the seam of a turning base takes the disks to touch: even where
/// they graze the steps shrink by a third each time, so that rounding is all that is left of the gap.
constexpr int MAX_SEAM_STEPS = 200;
}  // namespace

std::optional<double> PairSearch::contactAcrossSeam(const Disk& other, int shift, double distance) const
{
  if (machine_.motion().turning())
    return contactAcrossTurningSeam(other, shift, distance);
  return contact(other, machine_.image(shift, from_), distance);
}

/// While the base turns, the image moves on an arc, and the search is the base's: steps for which
/// the distance is free for certain.
std::optional<double> PairSearch::contactAcrossTurningSeam(const Disk& other, int shift,
                                                           double distance) const
{
  const double gravity = machine_.scene().gravity;
  const double rate = machine_.motion().inclinationRate();
  const double acceleration = machine_.sawtooth().width() * rate * rate;
  const double resolution = timeResolution(machine_.epoch().length);
  double time = from_;
  for (int step = 0; time < until_; ++step)
  {
    const Disk a = flown(disk_, time, gravity);
    const Disk b = flown(other, time, gravity);
    const Image there = machine_.image(shift, time);
    const double dx = a.x - b.x - there.dx;
    const double dy = a.y - b.y - there.dy;
    const double length = std::sqrt(dx * dx + dy * dy);
    const double opening = (dx * (a.vx - b.vx - there.dvx) + dy * (a.vy - b.vy - there.dvy)) / length;
    const double wait = guaranteedFreeTime(length - distance, opening, acceleration);
    if (opening < 0.0 && (wait <= resolution || step > MAX_SEAM_STEPS))
      return time;
    time += std::max(wait, resolution);
  }
  return std::nullopt;
}

}  // namespace ratchet_sieve
