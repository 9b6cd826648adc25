#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "model/base_motion.h"
#include "model/base_shape.h"
#include "model/disk.h"

namespace ratchet_sieve
{

/// The next time at which a gap + rate t + accel t^2 / 2 reaches 0 while decreasing: the smallest t >= 0. 0
/// if the gap is negative and decreasing. A negative gap that increases is ignored until it decreases again
/// (Bannerman et al., Comput. Part. Mech. 1, 191 (2014), arXiv 1211.6718).
inline std::optional<double> firstClosingTime(double gap, double rate, double accel)
{
  if (gap <= 0.0)
  {
    if (rate < 0.0)
      return 0.0;
    if (accel >= 0.0)
      return std::nullopt;
    return 2.0 * rate / -accel;
  }
  if (accel == 0.0)
    return rate < 0.0 ? std::optional<double>(gap / -rate) : std::nullopt;
  const double discriminant = rate * rate - 2.0 * accel * gap;
  if (rate < 0.0)
  {
    if (discriminant < 0.0)
      return std::nullopt;
    return 2.0 * gap / (std::sqrt(discriminant) - rate);
  }
  if (accel > 0.0)
    return std::nullopt;
  return (rate + std::sqrt(discriminant)) / -accel;
}

/// The time for which a gap is guaranteed positive if its second derivative is never below -bound (bound >=
/// 0): the time at which gap + rate t - bound t^2 / 2 reaches 0. 0 if the gap is negative and decreasing. A
/// negative gap that increases is free until it can have returned to 0; infinity if nothing brings it back.
inline double guaranteedFreeTime(double gap, double rate, double bound)
{
  if (rate >= 0.0 && bound <= 0.0)
    return std::numeric_limits<double>::infinity();
  const double discriminant = rate * rate + 2.0 * bound * gap;
  if (gap > 0.0)
  {
    const double root = std::sqrt(discriminant);
    return rate < 0.0 ? 2.0 * gap / (root - rate) : (rate + root) / bound;
  }
  if (rate < 0.0)
    return 0.0;
  return discriminant > 0.0 ? (rate + std::sqrt(discriminant)) / bound : rate / bound;
}

/// The next event of a disk with the base.
struct BaseEvent
{
  double time = 0.0;    ///< of the contact; without a contact, guaranteed free until then
  BaseFeature feature;  ///< none: search again from `time` on

  void archive(StateArchive& state) { state(time, feature); }
};

/// Finds a flying disk's first contact with the moving base by conservative advancement: no step is longer
/// than the time in which no feature can be reached. In the base's frame a disk's acceleration is bounded by
/// K, so that a gap g with rate g' stays positive as long as g + g' t - K t^2 / 2 > 0. This holds for the
/// distance to a line and to a point. Stepping from bound to bound converges to the first contact from the
/// free side, quadratically. For a base that turns, K includes the terms of the rotation.
class ContactSearch
{
public:
  ContactSearch(const BaseShape& shape, const BaseMotion& motion, double gravity, double time_resolution)
      : shape_(shape), motion_(motion), gravity_(gravity), time_resolution_(time_resolution)
  {
  }

  /// @param resolution times that differ by less are treated as equal [s]
  void setTimeResolution(double resolution) { time_resolution_ = resolution; }

  /// The first contact in [from, until], or the time until which the flight is guaranteed free. That time may
  /// be later than `until`, or earlier if the search took too many steps.
  /// @pre until <= the end of the motion's present segment
  /// @param base as last evaluated by the caller, usually at `from`
  BaseEvent find(const Disk& disk, const Kinematics& from, double until, BaseInstant& base) const;
  BaseEvent find(const Disk& disk, double from, double until) const
  {
    BaseInstant base(motion_);
    return find(disk, kinematicsAt(disk, from, gravity_), until, base);
  }

  /// The position and velocity of the disk relative to the base at `time`.
  BasePoint seenFromBase(const Disk& disk, double time) const
  {
    return motion_.at(time).see(kinematicsAt(disk, time, gravity_));
  }

private:
  struct Direction;
  class Step;

  /// A feature that is certain to be hit between two times from now, while its gap decreases.
  struct SureContact
  {
    BaseFeature feature;
    double gap = 0.0;                                           ///< [m]
    double rate = 0.0;                                          ///< < 0 [m/s]
    double earliest = std::numeric_limits<double>::infinity();  ///< [s]
    double latest = std::numeric_limits<double>::infinity();    ///< [s]
    double acceleration = 0.0;  ///< bound on the second derivative of the gap [m/s^2]
  };

  bool staysAbove(const Disk& disk, const Kinematics& from, double until, BaseInstant& base) const;
  bool staysAboveTurning(const Disk& disk, const Kinematics& from, double until,
                         const Rotation& rotation) const;
  std::optional<double> refine(const Disk& disk, const SureContact& sure, double time) const;
  double nearTime(double radius, const Kinematics& from) const;
  double relativeAccelerationBound(const BasePoint& point, double span) const;
  Direction forcedDirection() const;
  double longestSpan() const;
  void testEnds(Step& step) const;
  void testTeeth(Step& step) const;
  void testSection(std::int32_t tooth, const BaseShape::Section& section, Step& step) const;

  const BaseShape& shape_;
  const BaseMotion& motion_;
  double gravity_;
  double time_resolution_;
};

}  // namespace ratchet_sieve
