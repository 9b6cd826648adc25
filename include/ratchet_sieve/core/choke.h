#pragma once

#include <optional>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// The figures of a base that its feed chokes.
struct Choke
{
  double fed = 0.0;     ///< disks so far
  double left = 0.0;    ///< of all disks
  double layers = 0.0;  ///< by which the layer has risen [largest diameters]
};

/// Whether the feed chokes the base at time(): fewer than half as many disks have left as were fed, and the
/// others have raised the layer, at rest and over the whole base, by more than four of the largest diameters.
/// Nothing if not, and for disks that do not collide with each other. A base that fills up to the layer that
/// it conveys is thinner than that.
std::optional<Choke> chokeOf(const Simulation& simulation);

}  // namespace ratchet_sieve
