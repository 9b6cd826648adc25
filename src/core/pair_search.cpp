#include "ratchet_sieve/core/pair_search.h"

#include <algorithm>

#include "ratchet_sieve/core/quadratic.h"

namespace ratchet_sieve
{
namespace
{
/// Steps after which a search across the seam of a turning base settles for where it is: short of
/// the contact by less than rounding, for even grazing steps shrink by a third each time.
constexpr int MAX_STEPS = 200;

std::optional<double> findAcrossTurningSeam(const Machine& machine, const Disk& a, const Disk& b, int shift,
                                            double distance, double from, double until)
{
  const double gravity = machine.scene().gravity;
  const double rate = machine.motion().inclinationRate();
  const double acceleration = machine.sawtooth().width() * rate * rate;
  const double resolution = 1e-15 * machine.epoch().length;
  double time = from;
  for (int step = 0; time < until && step < MAX_STEPS; ++step)
  {
    const Disk now_a = flown(a, time, gravity);
    const Disk now_b = flown(b, time, gravity);
    const Image there = machine.image(shift, time);
    const double dx = now_a.x - now_b.x - there.dx;
    const double dy = now_a.y - now_b.y - there.dy;
    const double length = std::sqrt(dx * dx + dy * dy);
    const double opening =
        (dx * (now_a.vx - now_b.vx - there.dvx) + dy * (now_a.vy - now_b.vy - there.dvy)) / length;
    const double wait = guaranteedFreeTime(length - distance, opening, acceleration);
    if (opening < 0.0 && wait <= resolution)
      return time;
    time += std::max(wait, resolution);
  }
  return std::nullopt;
}
}  // namespace

std::optional<double> findPairContact(const Machine& machine, std::uint32_t i, std::uint32_t j, int shift,
                                      double from, double until)
{
  const Disk& a = machine.disk(i);
  const Disk& b = machine.disk(j);
  const double distance = machine.radius(i) + machine.radius(j);
  if (shift != 0 && machine.motion().turning())
    return findAcrossTurningSeam(machine, a, b, shift, distance, from, until);

  // The later parts of the two parabolas cancel, but for the different times of the two states.
  const double gravity = machine.scene().gravity;
  const double ta = from - a.time;
  const double tb = from - b.time;
  const Image there = machine.image(shift, from);
  const double dx = a.x + a.vx * ta - b.x - b.vx * tb - there.dx;
  const double dy =
      a.y + (a.vy - 0.5 * gravity * ta) * ta - b.y - (b.vy - 0.5 * gravity * tb) * tb - there.dy;
  const auto wait = timeToTouch(dx, dy, a.vx - b.vx, a.vy - b.vy - gravity * (ta - tb), distance);
  if (!wait || from + *wait >= until)
    return std::nullopt;
  return from + *wait;
}

}  // namespace ratchet_sieve
