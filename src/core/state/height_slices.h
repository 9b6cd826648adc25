#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "model/base_motion.h"
#include "ratchet_sieve/core/state_archive.h"
#include "state/disk_events.h"

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

/// Part of a flight, seen from the base: its velocity changes at a constant rate.
struct SeenFlight
{
  double duration;                       ///< > 0 [s]
  std::array<double, 2> height;          ///< at its start and its end [m]
  std::array<double, 2> along, upwards;  ///< velocity along the base and normal to it, at both [m/s]
  double weight;                         ///< of the disk: its mass in units of its species'
};

/// Integrals over time of the disks of one species, by the slice of height in which they are and by the part
/// of the drive's period. Each slice is of the same height; exact for a SeenFlight.
class HeightSlices
{
public:
  /// Disks above this many slices are counted as above.
  static constexpr std::size_t MOST = 1000;

  /// Over the disks and the time that they spend in a slice.
  struct Sums
  {
    double time = 0.0;     ///< [s]
    double weight = 0.0;   ///< of the weight [s]
    double along = 0.0;    ///< of weight and velocity [m]
    double upwards = 0.0;  ///< of weight and velocity [m]
    double squared = 0.0;  ///< of weight and velocity squared [m^2/s]

    Sums& operator+=(const Sums& other);

    /// The mean over the disks of their weight times the square of their velocity relative to that of their
    /// centre of mass [m^2/s^2]. @pre time > 0
    double variance() const;

    void archive(StateArchive& state) { state(time, weight, along, upwards, squared); }
  };

  /// @param height of a slice [m] @param parts of a period
  HeightSlices(double height, std::size_t parts) : height_(height), parts_(parts) {}

  /// Adds a flight within one part of a period.
  void add(const SeenFlight& flight, std::size_t part);

  /// Slices up to the highest that a disk was in.
  std::size_t count() const { return sums_.size() / parts_; }
  const Sums& at(std::size_t slice, std::size_t part) const { return sums_[slice * parts_ + part]; }

  double time() const { return time_; }                       ///< of all disks [s]
  double heightIntegral() const { return height_integral_; }  ///< over disks and time [m s]
  double timeAbove() const { return time_above_; }            ///< of disks above all slices [s]

  void archive(StateArchive& state) { state(sums_, time_, height_integral_, time_above_); }

private:
  /// A velocity and its rate of change.
  struct Linear
  {
    double start, rate;
    double at(double time) const { return start + rate * time; }
  };
  struct Fall;

  void addMonotone(const Fall& fall, double from, double to, std::size_t part);
  void addWithin(const Fall& fall, double from, double to, std::size_t slice, std::size_t part);
  std::size_t sliceAt(double height) const;

  double height_;
  std::size_t parts_;
  std::vector<Sums> sums_;  ///< per slice and part
  double time_ = 0.0;
  double height_integral_ = 0.0;
  double time_above_ = 0.0;
};

}  // namespace ratchet_sieve
