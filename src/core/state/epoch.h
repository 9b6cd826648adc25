#pragma once

#include "ratchet_sieve/core/state_archive.h"

namespace ratchet_sieve
{

/// The run's zero of time, moved by whole epochs: times within an epoch are small, so that their resolution
/// after 10^6 s is the same as at the start. A power of two [s], so that no rounding occurs.
struct Epoch
{
  double start = 0.0;   ///< [s]
  double length = 1.0;  ///< [s]

  void archive(StateArchive& state) { state(start, length); }
};

}  // namespace ratchet_sieve
