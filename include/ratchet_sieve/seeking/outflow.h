#pragma once

#include <string>
#include <vector>

#include "ratchet_sieve/core/segregation.h"

namespace ratchet_sieve
{

/// The disks that left a sieve in one time window, or in several at one inclination.
struct Outflow
{
  std::vector<std::string> species;  ///< name
  std::vector<SpeciesBins>
      bins;               ///< per species: left within the windows; on the base at the end of the last
  double duration = 0.0;  ///< of the windows [s]

  /// Adds another window of the same sieve.
  void add(const Outflow& more);
};

}  // namespace ratchet_sieve
