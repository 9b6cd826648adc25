#pragma once

#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// One line of figures if the feed chokes the base at time(): fewer than half as many disks have left as were
/// fed, and the others have raised the layer, at rest and over the whole base, by more than four of the
/// largest diameters. Empty otherwise, and for disks that do not collide with each other. A base that fills
/// up to the layer that it conveys is thinner than that.
std::string chokeText(const Simulation& simulation);

}  // namespace ratchet_sieve
