#pragma once

#include <limits>
#include <optional>

#include "model/base_motion.h"
#include "model/disk.h"
#include "model/sawtooth.h"

namespace ratchet_sieve
{

/// The next event of a disk's flight with the base.
struct BaseEvent
{
  double time = 0.0;    ///< of the contact; without one, free until then
  BaseFeature feature;  ///< none: search again from `time` on

  void archive(StateArchive& state) { state(time, feature); }
};

/// Finds a flying disk's first contact with the moving base, with certainty: it never steps further
/// than no feature can have come. In the base's frame a disk's acceleration is bounded by K, so
/// that a gap g with rate g' stays free as long as g + g' t - K t^2 / 2 > 0; this holds for the
/// distance to a line and for the distance to a point alike. Stepping from bound to bound comes to
/// the first contact from the free side, and quadratically (conservative advancement). The same
/// search serves a base that turns, with a K that takes the turning in.
class ContactSearch
{
public:
  /// @param search_above_band steps even where the base cannot reach; see Plan
  ContactSearch(const Sawtooth& sawtooth, const BaseMotion& motion, double gravity, double time_resolution,
                bool search_above_band = false)
      : sawtooth_(sawtooth),
        motion_(motion),
        gravity_(gravity),
        time_resolution_(time_resolution),
        search_above_band_(search_above_band)
  {
  }

  /// @param resolution times closer than this count as equal [s]
  void setTimeResolution(double resolution) { time_resolution_ = resolution; }

  /// The first contact in [from, until], or how far the flight is free for certain (which may be
  /// beyond `until`, or before it where a search took too many steps).
  /// @pre from >= disk.time, until <= the end of the motion's present segment
  /// @param base as the caller evaluated it last, most often at `from`
  BaseEvent find(const Disk& disk, double radius, double from, double until, BaseInstant& base) const;
  BaseEvent find(const Disk& disk, double radius, double from, double until) const
  {
    BaseInstant base(motion_);
    return find(disk, radius, from, until, base);
  }

  /// The disk as seen from the base's frame at `time`. Velocities are relative to the base.
  // As a call it costs 1 % of a run.
  [[gnu::always_inline]] BasePoint seenFromBase(const Disk& disk, const FrameOfBase& base, double time) const
  {
    const Course now = courseAt(disk, time, gravity_);
    return base.see(vectorOf(now.position), vectorOf(now.velocity));
  }
  BasePoint seenFromBase(const Disk& disk, double time) const
  {
    return seenFromBase(disk, motion_.at(time), time);
  }

private:
  struct Direction;
  class Step;

  /// A feature that will be hit between two times from now, its gap closing all the while.
  struct SureContact
  {
    BaseFeature feature;
    double gap = 0.0;                                           ///< [m]
    double rate = 0.0;                                          ///< < 0 [m/s]
    double earliest = std::numeric_limits<double>::infinity();  ///< [s]
    double latest = std::numeric_limits<double>::infinity();    ///< [s]
    double acceleration = 0.0;                                  ///< bounds that of the gap [m/s^2]
  };

  bool staysAbove(const Disk& disk, double radius, double from, double until) const;
  std::optional<double> refine(const Disk& disk, double radius, const SureContact& sure, double time) const;
  double nearTime(const Disk& disk, double radius, double from) const;
  double relativeAccelerationBound(const BasePoint& point, double span) const;
  Direction forcedDirection() const;
  double longestSpan() const;
  void testEnds(Step& step) const;
  void testTeeth(Step& step) const;
  void testTooth(std::int32_t tooth, Step& step) const;

  const Sawtooth& sawtooth_;
  const BaseMotion& motion_;
  double gravity_;
  double time_resolution_;
  bool search_above_band_;
};

}  // namespace ratchet_sieve
