#pragma once

#include "model/sine.h"

namespace ratchet_sieve
{

/// The drive with its frequency and amplitude at one instant: Y = A sin(phi), upwards in the world.
struct Drive
{
  double amplitude;     ///< A [m]
  double speed;         ///< A w, w = 2 pi f: largest speed of the base [m/s]
  double acceleration;  ///< A w^2: largest acceleration of the base [m/s^2]
  double frequency;     ///< f [Hz]
  double start;         ///< the instant [s]
  double turns;         ///< phi / (2 pi) at `start`
};

RATCHET_SIEVE_INLINE double angularFrequency(double frequency)
{
  return RADIANS_PER_TURN * frequency;
}

RATCHET_SIEVE_INLINE Drive driveOf(double amplitude, double frequency, double start, double turns)
{
  const double rate = angularFrequency(frequency);
  const double speed = amplitude * rate;
  return {amplitude, speed, speed * rate, frequency, start, turns};
}

/// Displacement, velocity and acceleration of the base by its drive, upwards in the world.
template <typename Number>
struct Stroke
{
  Number displacement;  ///< Y [m]
  Number velocity;      ///< dY/dt [m/s]
  Number acceleration;  ///< d2Y/dt2 [m/s^2]
};

/// At a phase, for constant frequency and amplitude.
template <typename Number>
RATCHET_SIEVE_INLINE Stroke<Number> strokeAtPhase(const Drive& drive, const SineCosine<Number>& phase)
{
  return {drive.amplitude * phase.sine, drive.speed * phase.cosine, -(drive.acceleration * phase.sine)};
}

/// At a time, for frequency and amplitude that are constant from `start` on.
template <typename Number>
RATCHET_SIEVE_INLINE Stroke<Number> strokeAt(const Drive& drive, Number time)
{
  return strokeAtPhase(drive, sineCosineOfTurns(drive.turns + (time - drive.start) * drive.frequency));
}

}  // namespace ratchet_sieve
