#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ratchet_sieve/core/simulation.h"
#include "ratchet_sieve/recording/certainty.h"
#include "ratchet_sieve/recording/proportions.h"

namespace ratchet_sieve
{

/// One species in one bin since the machine has filled.
struct SteadyBin
{
  double number = 0.0;
  double mass = 0.0;          ///< [kg]
  PortionEstimates purity;    ///< its share of the bin
  PortionEstimates recovery;  ///< the bin's share of what left of it
};

struct SteadySpecies
{
  SteadyBin left;
  SteadyBin right;
};

/// What a machine with a feed does once it has filled.
struct SteadyState
{
  double from = 0.0;                   ///< in the run's time [s]
  std::optional<PairSeparation> pair;  ///< of bestSeparation()
  std::optional<Estimate> separation;  ///< nothing before one disk of each of two species has left
  std::optional<Estimate> separation_by_mass;
  Estimate inside;                          ///< mean number of disks in the machine
  std::optional<Estimate> throughput;       ///< disks that leave [1/s]; nothing if they are too correlated
  std::optional<Estimate> mass_throughput;  ///< [kg/s]
  std::vector<SteadySpecies> species;
};

/// A steady state, or why there is none.
struct Steadiness
{
  std::optional<SteadyState> state;
  std::string reason;                ///< in one line; empty if there is one
  std::optional<double> needs = {};  ///< of fillingOf()
};

/// Does not change the run. With the confidence level of its scene. See fillingOf().
Steadiness steadinessOf(const Simulation& simulation);

/// A warning of one line if the separation since the start differs from the steady one by more than either's
/// half-width; empty otherwise.
std::string steadyText(const Simulation& simulation, const Steadiness& steadiness,
                       const Certainty& certainty);

}  // namespace ratchet_sieve
