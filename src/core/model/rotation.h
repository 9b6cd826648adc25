#pragma once

#include "ratchet_sieve/core/numbers.h"

/// Rotation between the axes of the world (x, y) and of the inclined base (s along it, n normal to it): the
/// only place, used for single disks and for SIMD. Component by component and without Eigen, whose functions
/// the SIMD kernels must not instantiate: see numbers.h.
namespace ratchet_sieve
{

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

}  // namespace ratchet_sieve
