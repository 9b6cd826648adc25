#pragma once

#include "ratchet_sieve/core/numbers.h"

/// A disk's free flight for a time `elapsed` [s], along each axis of any frame that is not accelerated:
/// `position` [m], `velocity` [m/s], and `fall`, the decrease of the velocity by gravity: g elapsed,
/// downwards [m/s].
namespace ratchet_sieve
{

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

/// The number of whole widths W by which a position s along a periodic base is outside of [0, W).
/// @param per_width 1 / W [1/m]
template <typename Number>
RATCHET_SIEVE_INLINE Number wholeWidths(Number s, double per_width)
{
  return floored(s * per_width);
}

}  // namespace ratchet_sieve
