#pragma once

#include <vector>

#include "ratchet_sieve/seeking/goal.h"
#include "ratchet_sieve/seeking/outflow.h"

namespace ratchet_sieve
{

/// The disks that left a sieve in a time window at one inclination.
struct Separation : Outflow
{
  double inclination = 0.0;                  ///< theta, applied [rad]
  double begin = 0.0;                        ///< of the window, simulated [s]
  double end = 0.0;                          ///< of the window [s]
  std::vector<double> granular_temperature;  ///< per species, mean over the window [J]; 0 where undefined;
                                             ///< empty if none was received
  double real_time_factor = 0.0;             ///< achieved over the window; 0 if none was received
};

/// The measures of separation computed from counts of disks.
struct Score
{
  Measured goal;     ///< what the search maximises
  Measured quality;  ///< Q; undefined if no disk of a species left

  /// Net flow to the right, each species with the same weight, in [-1, 1]. 1: all disks leave on the right;
  /// 0: as many on the left as on the right. |balance| + Q <= 1.
  double balance = 0.0;
};

/// Balance over all species.
Score scoreOf(const Outflow& outflow, const Goal& goal = {});

}  // namespace ratchet_sieve
