#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "model/base_motion.h"

namespace ratchet_sieve
{

/// Divides time into steps in which the base's acceleration hardly changes, and the periods of the drive into
/// parts. Steps begin at fixed phases, so that they do not depend on who asks.
class MotionSteps
{
public:
  /// Steps in a sine's period. Within one, a parabola through both ends with the velocities there is at most
  /// 6e-5 amplitudes from the sine: (2 pi / 32)^3 / 72 sqrt(3).
  static constexpr std::size_t PER_PERIOD = 32;

  /// The largest turn of the base within a step [rad].
  static constexpr double LARGEST_TURN = 0.01;

  /// @param parts of a period @param highest_multiple of the drive's sines
  MotionSteps(std::size_t parts, int highest_multiple)
      : parts_(parts),
        per_part_((PER_PERIOD * static_cast<std::size_t>(highest_multiple) + parts - 1) / parts)
  {
  }

  std::size_t parts() const { return parts_; }

  /// Calls visit(from, to, part) for consecutive steps from `begin` to `end`, local to the epoch [s].
  /// @pre both are within the present segment of the motion
  template <typename Visit>
  void forEach(const BaseMotion& motion, double begin, double end, Visit&& visit) const
  {
    const std::size_t per_period = parts_ * (motion.swings() ? per_part_ : 1);
    const double turn = std::abs(motion.inclinationRate());
    const double longest = turn > 0.0 ? LARGEST_TURN / turn : std::numeric_limits<double>::infinity();
    auto step =
        static_cast<std::uint64_t>(std::max(0.0, motion.turnsAt(begin)) * static_cast<double>(per_period));
    for (double from = begin; from < end; ++step)
    {
      const auto next = motion.timeOfTurns(static_cast<double>(step + 1) / static_cast<double>(per_period));
      const double last = std::min(next.value_or(end), end);
      const std::size_t part = step % per_period * parts_ / per_period;
      while (from < last)
      {
        const double to = std::min(last, from + longest);
        visit(from, to, part);
        from = to > from ? to : last;
      }
    }
  }

private:
  std::size_t parts_;
  std::size_t per_part_;  ///< steps
};

}  // namespace ratchet_sieve
