#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/core/segregation.h"

namespace ratchet_sieve
{

/// What left a sieve within a window of time, while its base stood at one inclination.
struct Separation
{
  double inclination = 0.0;          ///< theta, applied [rad]
  double begin = 0.0;                ///< of the window, simulated [s]
  double end = 0.0;                  ///< of the window [s]
  std::vector<std::string> species;  ///< name
  std::vector<SpeciesBins> bins;     ///< per species: fallen within the window; on the base at its end
  std::vector<double> granular_temperature;  ///< per species, mean over the window [J]; 0 where undefined;
                                             ///< empty if none was received
  double real_time_factor = 0.0;             ///< achieved over the window; 0 if none was received
};

/// What counts of disks say about the separation.
struct Score
{
  double quality = 0.0;  ///< Q, eq. (2) of the paper; 0 where a species kept back leaves it undefined
  double error = 0.0;    ///< standard error of Q from the number of disks; 0 where Q is undefined
  bool defined = false;

  /// How much more goes right than left, each species with the same weight, in [-1, 1]: at 1 all of them
  /// go right, at 0 as much goes left as right. |balance| + Q <= 1.
  double balance = 0.0;
};

/// The score of the pair of species with the highest Q; balance over all that left.
Score scoreOf(const std::vector<SpeciesBins>& bins);

/// Adds what fell; on_base becomes that of `more`. @param sum empty, or as many species as `more`
void addBins(std::vector<SpeciesBins>& sum, const std::vector<SpeciesBins>& more);

}  // namespace ratchet_sieve
