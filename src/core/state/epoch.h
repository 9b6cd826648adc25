#pragma once

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The run's time zero, moved on by whole epochs: times within an epoch are small, so that a double
/// holds them as finely after 10^6 s as at the start. A power of two [s], so that nothing rounds.
struct Epoch
{
  double start = 0.0;   ///< [s]
  double length = 1.0;  ///< [s]

  void archive(StateArchive& state) { state(start, length); }
};

}  // namespace ratchet_sieve
