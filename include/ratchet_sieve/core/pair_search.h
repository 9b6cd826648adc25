#pragma once

#include <cmath>
#include <optional>

#include "ratchet_sieve/core/machine.h"

namespace ratchet_sieve
{

/// How long until two disks touch whose relative place is (dx, dy) and relative velocity (dvx, dvy):
/// under one gravity the relative motion is a straight line. Nothing if they pass or part; 0 where
/// they overlap and close.
inline std::optional<double> timeToTouch(double dx, double dy, double dvx, double dvy, double distance)
{
  const double closing = dx * dvx + dy * dvy;
  if (closing >= 0.0)
    return std::nullopt;
  const double excess = dx * dx + dy * dy - distance * distance;
  if (excess <= 0.0)
    return 0.0;
  const double speed_squared = dvx * dvx + dvy * dvy;
  const double discriminant = closing * closing - speed_squared * excess;
  if (discriminant < 0.0)
    return std::nullopt;
  return excess / (std::sqrt(discriminant) - closing);
}

/// When disk i touches the image of disk j that lies `shift` widths to the right of j, in
/// [from, until]. On a base that turns the image moves on an arc, and the search is the base's:
/// steps for which the distance is free for certain.
std::optional<double> findPairContact(const Machine& machine, std::uint32_t i, std::uint32_t j, int shift,
                                      double from, double until);

}  // namespace ratchet_sieve
