#pragma once

#include "ratchet_sieve/core/numbers.h"

namespace ratchet_sieve
{

constexpr double RADIANS_PER_TURN = 6.283185307179586476925;  ///< 2 pi

template <typename Number>
struct SineCosine
{
  Number sine;
  Number cosine;
};

/// Rotates by an integer number of quarter turns, which determines the swap of sine and cosine and the signs.
template <typename Number>
RATCHET_SIEVE_INLINE SineCosine<Number> turnedByQuarters(const SineCosine<Number>& angle, Number quarters)
{
  // The quarter within its turn, in {-2, -1, 0, 1, 2}; if it is odd, sine and cosine are swapped.
  const Number quarter = quarters - 4.0 * rounded(quarters * 0.25);
  const Number distance = absolute(quarter);
  const auto odd = both(less(like(quarter, 0.5), distance), less(distance, like(quarter, 1.5)));
  const auto opposite = less(like(quarter, 1.5), distance);
  const Number sine = select(odd, angle.cosine, angle.sine);
  const Number cosine = select(odd, angle.sine, angle.cosine);
  return {select(either(opposite, less(quarter, like(quarter, -0.5))), -sine, sine),
          select(either(opposite, less(like(quarter, 0.5), quarter)), -cosine, cosine)};
}

RATCHET_SIEVE_INLINE unsigned long long bitsOf(double value)
{
  unsigned long long bits;
  __builtin_memcpy(&bits, &value, sizeof bits);
  return bits;
}

RATCHET_SIEVE_INLINE double doubleOf(unsigned long long bits)
{
  double value;
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

/// turnedByQuarters() of one double, with bit operations: compilers turn the selections into branches, which
/// are unpredictable. For random angles, sine and cosine take 8.3 ns, and 59 ns with the selections (AMD
/// EPYC, g++ 12, 2026-11-22).
RATCHET_SIEVE_INLINE SineCosine<double> turnedByQuarters(const SineCosine<double>& angle, double quarters)
{
  const auto quarter = static_cast<unsigned long long>(static_cast<long long>(quarters));
  const unsigned long long swap = 0 - (quarter & 1);
  const unsigned long long s = bitsOf(angle.sine);
  const unsigned long long c = bitsOf(angle.cosine);
  return {doubleOf(((s & ~swap) | (c & swap)) ^ ((quarter & 2) << 62)),
          doubleOf(((c & ~swap) | (s & swap)) ^ (((quarter + 1) & 2) << 62))};
}

/// sin and cos of 2 pi `turns`, |turns| < 2^49, to within 2 ulp. Own code, because every machine must give
/// the same bits, and the C library selects its code by processor. The polynomials are those of FDLIBM
/// (k_sin.c, k_cos.c; Sun Microsystems, 1993) on [-pi/4, pi/4].
template <typename Number>
RATCHET_SIEVE_INLINE SineCosine<Number> sineCosineOfTurns(Number turns)
{
  const Number quarters = rounded(turns * 4.0);
  const Number z = (turns - quarters * 0.25) * RADIANS_PER_TURN;
  const Number zz = z * z;
  const Number s =
      z + z * zz *
              (-1.66666666666666324348e-01 +
               zz * (8.33333333332248946124e-03 +
                     zz * (-1.98412698298579493134e-04 +
                           zz * (2.75573137070700676789e-06 +
                                 zz * (-2.50507602534068634195e-08 + zz * 1.58969099521155010221e-10)))));
  const Number c =
      1.0 - 0.5 * zz +
      zz * zz *
          (4.16666666666666019037e-02 +
           zz * (-1.38888888888741095749e-03 +
                 zz * (2.48015872894767294178e-05 +
                       zz * (-2.75573143513906633035e-07 +
                             zz * (2.08757232129817482790e-09 + zz * -1.13596475577881948265e-11)))));
  return turnedByQuarters(SineCosine<Number>{s, c}, quarters);
}

/// Rotation between the axes of the world (x, y) and of the inclined base (s along it, n normal to it): the
/// only place, used for single disks and for SIMD. Component by component and without Eigen, whose functions
/// the SIMD kernels must not instantiate: see numbers.h.

/// By the base's inclination theta, counter-clockwise.
struct Rotation
{
  double cosine;
  double sine;
};

/// Of a vector, along the first and the second axis.
template <typename Number>
struct Components
{
  Number first;
  Number second;
};

/// (x, y) -> (s, n)
template <typename Number>
RATCHET_SIEVE_INLINE Components<Number> intoBase(const Rotation& base, Number x, Number y)
{
  return {base.cosine * x + base.sine * y, base.cosine * y - base.sine * x};
}

/// (0, y) -> (s, n)
template <typename Number>
RATCHET_SIEVE_INLINE Components<Number> verticalIntoBase(const Rotation& base, Number y)
{
  return {base.sine * y, base.cosine * y};
}

/// (s, n) -> (x, y)
template <typename Number>
RATCHET_SIEVE_INLINE Components<Number> outOfBase(const Rotation& base, Number s, Number n)
{
  return {base.cosine * s - base.sine * n, base.sine * s + base.cosine * n};
}

/// (s, 0) -> (x, y)
template <typename Number>
RATCHET_SIEVE_INLINE Components<Number> alongBase(const Rotation& base, Number s)
{
  return {base.cosine * s, base.sine * s};
}

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

/// A disk's free flight for a time `elapsed` [s], along each axis of any frame that is not accelerated:
/// `position` [m], `velocity` [m/s], and `fall`, the decrease of the velocity by gravity: g elapsed,
/// downwards [m/s].

/// @tparam Coordinate a number, or several axes side by side (Two)
template <typename Coordinate, typename Number>
RATCHET_SIEVE_INLINE Coordinate positionAfter(Coordinate position, Coordinate velocity, Coordinate fall,
                                              Number elapsed)
{
  return position + (velocity - 0.5 * fall) * elapsed;
}

/// Along an axis without gravity, or of an angle with its spin.
template <typename Number>
RATCHET_SIEVE_INLINE Number positionAfter(Number position, Number velocity, Number elapsed)
{
  return position + velocity * elapsed;
}

template <typename Coordinate>
RATCHET_SIEVE_INLINE Coordinate velocityAfter(Coordinate velocity, Coordinate fall)
{
  return velocity - fall;
}

/// The integral of v^2 / 2 over the flight [m^2/s]: times m, of the kinetic energy.
/// @param vx, vy at its start [m/s]
template <typename Number>
RATCHET_SIEVE_INLINE Number translationOver(Number vx, Number vy, Number fall, Number elapsed)
{
  return 0.5 * elapsed * (vx * vx + vy * vy - vy * fall + fall * fall * (1.0 / 3.0));
}

/// The integral of spin^2 / 2 over the flight [1/s]: times I, of the kinetic energy.
template <typename Number>
RATCHET_SIEVE_INLINE Number rotationOver(Number spin, Number elapsed)
{
  return 0.5 * elapsed * spin * spin;
}

/// What translationOver() was more, had the disk been on the flight (vx, vy) in place of (to_vx, to_vy) until
/// now.
template <typename Number>
RATCHET_SIEVE_INLINE Number translationChange(Number vx, Number vy, Number to_vx, Number to_vy, Number fall,
                                              Number elapsed)
{
  return 0.5 * elapsed * ((vx - to_vx) * (vx + to_vx) + (vy - to_vy) * (vy + to_vy - fall));
}

/// The same of rotationOver().
template <typename Number>
RATCHET_SIEVE_INLINE Number rotationChange(Number spin, Number to_spin, Number elapsed)
{
  return 0.5 * elapsed * ((spin - to_spin) * (spin + to_spin));
}

/// The number of whole widths W by which a position s along a periodic base is outside of [0, W).
/// @param per_width 1 / W [1/m]
template <typename Number>
RATCHET_SIEVE_INLINE Number wholeWidths(Number s, double per_width)
{
  return floored(s * per_width);
}

}  // namespace ratchet_sieve
