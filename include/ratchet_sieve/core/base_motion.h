#pragma once

#include <array>
#include <limits>
#include <optional>

#include "ratchet_sieve/core/commanded_quantity.h"
#include "ratchet_sieve/core/definition.h"
#include "ratchet_sieve/core/observation.h"

namespace ratchet_sieve
{

/// Where the base is at an instant, and how it moves.
struct BaseKinematics
{
  double inclination = 0.0;       ///< theta [rad]
  double inclination_rate = 0.0;  ///< d theta / dt [rad/s]
  double cosine = 1.0;            ///< of theta
  double sine = 0.0;              ///< of theta
  double displacement = 0.0;      ///< Y [m]
  double velocity = 0.0;          ///< dY/dt [m/s]

  void archive(StateArchive& state)
  {
    state(inclination, inclination_rate, cosine, sine, displacement, velocity);
  }
};

/// The base's motion over time: theta, f and A each stand still or follow their setpoint at a
/// constant rate; the phase of the drive is continuous. Piecewise: within a segment nothing changes
/// its rate; nextChange() ends it. Times are local to the engine's present epoch [s].
class BaseMotion
{
public:
  /// @param max_turn the largest change of theta within one segment [rad]
  /// @param always_drive works out the drive even where it does not move the base; see Plan
  BaseMotion(const BaseDefinition& base, double max_turn, bool always_drive = false);

  BaseKinematics at(double time) const
  {
    BaseKinematics k;
    lookAt(time, k);
    return k;
  }

  /// The same, put straight where it is wanted.
  void lookAt(double time, BaseKinematics& k) const;
  DriveState state(double time) const;

  double segmentStart() const { return segment_start_; }

  /// Of theta at the segment's start: while the base does not turn, of theta as it is.
  double cosine() const { return cosine_; }
  double sine() const { return sine_; }

  /// A, f and the phase over 2 pi at the segment's start: while nothing changes, of the drive as it is.
  double amplitude() const { return ramp(Quantity::AMPLITUDE).start; }
  double frequency() const { return ramp(Quantity::FREQUENCY).start; }
  double startTurns() const { return turns_; }

  /// When the present segment ends; nothing while the base stands at its setpoints.
  std::optional<double> nextChange() const { return next_change_; }

  /// Begins a new segment at `time`: at nextChange(), or earlier, with setpoints changed.
  void beginSegment(double time);

  /// Makes `length` the new time zero; length is a power of two so that the phase stays exact.
  void rebase(double length);

  /// The motion begins at `time`, not at 0. @pre nothing was commanded
  void startAt(double time) { segment_start_ = time; }

  void command(Quantity quantity, double target, double time);
  void setSlewRates(const SlewRates& rates, double time);

  bool turning() const { return inclinationRate() != 0.0; }

  /// d theta / dt over the present segment [rad/s].
  double inclinationRate() const { return ramp(Quantity::INCLINATION).rate; }

  /// sup |d2Y/dt2| over the present segment [m/s^2].
  double accelerationBound() const { return acceleration_bound_; }

  /// How high the drive throws a disk that leaves it at its highest speed [m]; infinity without gravity.
  double throwHeight(double gravity) const;

  /// sup |Y| over the present segment [m].
  double displacementBound() const { return displacement_bound_; }

  void archive(StateArchive& state)
  {
    state(ramps_[0], ramps_[1], ramps_[2], slew_rates_, segment_start_, turns_, cosine_, sine_,
          next_change_, acceleration_bound_, displacement_bound_);
    noteStandstill();
  }

private:
  /// A quantity that moves from `start` at `rate` until it reaches `target`.
  struct Ramp
  {
    double start = 0.0;
    double rate = 0.0;
    double target = 0.0;

    double at(double elapsed) const { return start + rate * elapsed; }
    std::optional<double> remaining() const;
    void advance(double elapsed);
    void archive(StateArchive& state) { state(start, rate, target); }
  };

  Ramp& ramp(Quantity quantity) { return ramps_[indexOf(quantity)]; }
  const Ramp& ramp(Quantity quantity) const { return ramps_[indexOf(quantity)]; }
  double turns(double elapsed) const;
  void advanceTo(double time);  ///< moves the segment's start to `time`, on the rates so far
  void pursue(Ramp& ramp, double slew_rate) const;
  void plan();  ///< sets the rates from the setpoints, and when they end
  void updateBounds();
  void noteStandstill();

  std::array<Ramp, QUANTITIES> ramps_;  ///< in the order of Quantity
  SlewRates slew_rates_;
  double max_turn_;
  bool always_drive_;
  double segment_start_ = 0.0;
  double turns_ = 0.0;  ///< phase of the drive at segment_start_ over 2 pi, in [0, 1)
  double cosine_ = 1.0;
  double sine_ = 0.0;
  std::optional<double> next_change_;
  double acceleration_bound_ = 0.0;
  double displacement_bound_ = 0.0;
  bool oscillates_ = true;   ///< over the present segment
  double standstill_ = 0.0;  ///< Y where the base does not oscillate [m]
};

/// The base at the instant that was last asked for: what happens at one time asks several times.
class BaseInstant
{
public:
  explicit BaseInstant(const BaseMotion& motion) : motion_(motion) {}

  const BaseKinematics& at(double time)
  {
    if (!(time == time_))
    {
      time_ = time;
      motion_.lookAt(time, base_);
    }
    return base_;
  }

  /// The motion, or the zero of time, has changed.
  void forget() { time_ = std::numeric_limits<double>::quiet_NaN(); }

private:
  const BaseMotion& motion_;
  double time_ = std::numeric_limits<double>::quiet_NaN();
  BaseKinematics base_;
};

}  // namespace ratchet_sieve
