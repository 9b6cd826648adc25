#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/core/segregation.h"

namespace ratchet_sieve
{

/// The disks that left a sieve in a time window at one inclination.
struct Separation
{
  double inclination = 0.0;                  ///< theta, applied [rad]
  double begin = 0.0;                        ///< of the window, simulated [s]
  double end = 0.0;                          ///< of the window [s]
  std::vector<std::string> species;          ///< name
  std::vector<SpeciesBins> bins;             ///< per species: left within the window; on the base at its end
  std::vector<double> granular_temperature;  ///< per species, mean over the window [J]; 0 where undefined;
                                             ///< empty if none was received
  double real_time_factor = 0.0;             ///< achieved over the window; 0 if none was received
};

/// The measures of separation computed from counts of disks.
struct Score
{
  double quality = 0.0;  ///< Q, eq. (2) of the paper; 0 if undefined because no disk of a species left
  double error = 0.0;    ///< standard error of Q from the number of disks; 0 if Q is undefined
  bool defined = false;

  /// Net flow to the right, each species with the same weight, in [-1, 1]. 1: all disks leave on the right;
  /// 0: as many on the left as on the right. |balance| + Q <= 1.
  double balance = 0.0;
};

/// Q of the pair of species with the highest Q; balance over all species.
Score scoreOf(const std::vector<SpeciesBins>& bins);

/// Adds the counts in the bins; on_base is replaced by that of `more`. @param sum empty, or as many species
/// as `more`
void addBins(std::vector<SpeciesBins>& sum, const std::vector<SpeciesBins>& more);

}  // namespace ratchet_sieve
