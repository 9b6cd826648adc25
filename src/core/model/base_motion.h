#pragma once

#include <array>
#include <limits>
#include <optional>

#include "model/base_frame.h"
#include "model/motion.h"
#include "model/orbit.h"
#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/results.h"

namespace ratchet_sieve
{

/// The base's motion over time: theta, f and A are each constant or follow their setpoint at a constant rate;
/// the phase of the drive is continuous. The other parts of the drive use the same phase and are scaled with
/// A: by A over the scene's A, if that is not 0. The drive's axes are the world's or the base's, see
/// DriveFrame. Piecewise: within a segment no rate changes; nextChange()
/// ends it. Times are local to the engine's present epoch [s].
class BaseMotion
{
public:
  /// @param max_turn largest change of theta within one segment [rad]
  explicit BaseMotion(const BaseDefinition& base, double max_turn = std::numeric_limits<double>::infinity());

  FrameOfBase at(double time) const
  {
    FrameOfBase frame;
    evaluate(time, frame);
    return frame;
  }

  /// Writes at(time) directly into `frame`.
  void evaluate(double time, FrameOfBase& frame) const;
  DriveState state(double time) const;

  /// The periodic image at distance `length` along the base, relative to the disk itself, at `time`.
  Image image(double length, double time) const { return length == 0.0 ? Image() : at(time).image(length); }

  double segmentStart() const { return segment_start_; }

  /// For theta at the segment's start; valid for the whole segment while the base does not turn.
  const Rotation& rotation() const { return rotation_; }

  /// A sin(phi) at the segment's start; valid for the whole segment while A and f are constant.
  Drive drive() const { return driveOf(amplitude_.start, frequency_.start, segment_start_, turns_); }

  /// The end of the present segment; nothing while the base is at its setpoints.
  std::optional<double> nextChange() const { return next_change_; }

  /// Begins a new segment at `time`: at nextChange(), or earlier after a change of setpoints.
  void beginSegment(double time)
  {
    advanceTo(time);
    plan();
  }

  /// Makes `length` the new time zero. @param length a multiple of a power of two, so that the phase stays
  /// exact
  void rebase(double length);

  /// The motion begins at `time`, not at 0. @pre nothing was commanded
  void startAt(double time) { segment_start_ = time; }

  void command(Quantity quantity, double target, double time)
  {
    advanceTo(time);
    ramp(quantity).target = target;
    plan();
  }
  void setSlewRates(const SlewRates& rates, double time)
  {
    advanceTo(time);
    slew_rates_ = rates;
    plan();
  }

  bool turning() const { return inclination_.rate != 0.0; }

  /// d theta / dt in the present segment [rad/s].
  double inclinationRate() const { return inclination_.rate; }

  /// Whether the drive moves the base in the present segment.
  bool swings() const { return hasStroke() && (frequency_.start != 0.0 || frequency_.rate != 0.0); }

  /// Phase of the drive over 2 pi at `time`, and the time of a later phase, extrapolated from the present
  /// segment; nothing if that phase is never reached. Whole turns before the segment are not counted.
  double turnsAt(double time) const { return turns(time - segment_start_); }
  std::optional<double> timeOfTurns(double turns) const;

  /// sup |d2D/dt2| of each component in the world over the present segment [m/s^2].
  const Eigen::Vector2d& accelerationBound() const { return world_acceleration_; }

  /// The length of accelerationBound().
  double greatestAcceleration() const { return greatest_acceleration_; }

  /// sup |dD/dt| of the oscillation, now and during the ramps to its setpoints [m/s].
  double speedBound() const;

  /// The height reached by a disk that leaves the base at its highest upward speed [m]; infinity without
  /// gravity.
  double throwHeight(double gravity) const;

  /// sup |D| of each component in the world over the present segment [m].
  const Eigen::Vector2d& displacementBound() const { return world_displacement_; }

  /// sup |D| along the base and normal to it, valid while it does not turn [m].
  const Eigen::Vector2d& reach() const { return reach_; }

  void archive(StateArchive& state)
  {
    state(inclination_, frequency_, amplitude_, slew_rates_, segment_start_, turns_, rotation_.cosine,
          rotation_.sine, next_change_, acceleration_bound_.x(), acceleration_bound_.y(),
          displacement_bound_.x(), displacement_bound_.y());
    noteDerived();
  }

private:
  /// A quantity that moves from `start` at `rate` until it reaches `target`.
  struct Ramp
  {
    double start = 0.0;
    double rate = 0.0;
    double target = 0.0;

    double at(double elapsed) const { return start + rate * elapsed; }
    std::optional<double> remaining() const
    {
      if (rate == 0.0)
        return std::nullopt;
      return (target - start) / rate;
    }
    void advance(double elapsed);
    void archive(StateArchive& state) { state(start, rate, target); }
  };

  Ramp& ramp(Quantity quantity) { return this->*RAMPS[indexOf(quantity)]; }
  const Ramp& ramp(Quantity quantity) const { return this->*RAMPS[indexOf(quantity)]; }
  double turns(double elapsed) const
  {
    return turns_ + elapsed * (frequency_.start + 0.5 * frequency_.rate * elapsed);
  }
  void advanceTo(double time);  ///< advances the segment's start to `time` at the present rates
  void pursue(Ramp& ramp, double slew_rate) const;
  void plan();  ///< sets the rates from the setpoints, and the ends of the ramps
  void updateBounds();
  void noteDerived();
  bool hasStroke() const;
  void followOrbit(double elapsed, FrameOfBase& frame) const;
  Eigen::Vector2d boundInWorld(const Eigen::Vector2d& bound) const;
  double driveSpeedBound() const;

  /// The scale factor of the orbit for this amplitude A.
  double orbitScale(double amplitude) const { return scaled_ ? amplitude / scene_amplitude_ : 1.0; }
  double orbitScaleRate() const { return scaled_ ? amplitude_.rate / scene_amplitude_ : 0.0; }

  Ramp inclination_;
  Ramp frequency_;
  Ramp amplitude_;
  /// In the order of Quantity.
  static constexpr std::array<Ramp BaseMotion::*, QUANTITIES> RAMPS = {
      &BaseMotion::inclination_, &BaseMotion::frequency_, &BaseMotion::amplitude_};
  SlewRates slew_rates_;
  Orbit orbit_;
  double scene_amplitude_;  ///< A of the scene [m]
  bool scaled_;             ///< whether scene_amplitude_ can scale the orbit
  double max_turn_;
  double segment_start_ = 0.0;
  double turns_ = 0.0;  ///< phase of the drive at segment_start_ over 2 pi, in [0, 1)
  Rotation rotation_{1.0, 0.0};
  std::optional<double> next_change_;
  Eigen::Vector2d acceleration_bound_ = Eigen::Vector2d::Zero();  ///< along the drive's axes [m/s^2]
  Eigen::Vector2d displacement_bound_ = Eigen::Vector2d::Zero();  ///< along the drive's axes [m]
  Eigen::Vector2d world_acceleration_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d world_displacement_ = Eigen::Vector2d::Zero();
  double greatest_acceleration_ = 0.0;
  Eigen::Vector2d reach_ = Eigen::Vector2d::Zero();
  bool oscillates_ = true;                                ///< in the present segment
  bool turned_ = false;                                   ///< the drive's axes are the base's
  bool orbits_ = false;                                   ///< has a horizontal part or harmonics
  bool plain_ = true;                                     ///< neither turned_ nor orbits_
  Eigen::Vector2d standstill_ = Eigen::Vector2d::Zero();  ///< D while the base does not oscillate [m]
};

/// Caches the state of the base at the last requested time, because simultaneous events request it several
/// times.
class BaseInstant
{
public:
  explicit BaseInstant(const BaseMotion& motion) : motion_(motion) {}

  const FrameOfBase& at(double time)
  {
    if (!(time == time_))
    {
      time_ = time;
      motion_.evaluate(time, frame_);
    }
    return frame_;
  }

  /// To be called after a change of the motion or of the zero of time.
  void forget() { time_ = std::numeric_limits<double>::quiet_NaN(); }

private:
  const BaseMotion& motion_;
  double time_ = std::numeric_limits<double>::quiet_NaN();
  FrameOfBase frame_;
};

}  // namespace ratchet_sieve
