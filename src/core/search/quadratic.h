#pragma once

#include <cmath>
#include <limits>
#include <optional>

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

}  // namespace ratchet_sieve
