#pragma once

#include <map>
#include <string>

#include "ratchet_sieve/core/simulation.h"

namespace ratchet_sieve
{

/// Quantities by their names, with values in their units.
using Setpoints = std::map<std::string, double>;

/// @throws std::invalid_argument a name that is none, a value that is not legal
void requireLegal(const Setpoints& setpoints);

/// @pre they are legal
void commandAll(const Setpoints& setpoints, Simulation& simulation);

/// @throws std::invalid_argument a rate that is not legal
void requireLegal(const SlewRates& rates);

}  // namespace ratchet_sieve
