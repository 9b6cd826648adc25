#pragma once

#include <cstddef>

namespace ratchet_sieve
{

class SystemState;

/// The result of a check of all disks at one time.
struct Audit
{
  double largest_overlap = 0.0;    ///< between two disks, or a disk and the base [m]
  std::size_t behind_surface = 0;  ///< disks with their centre below the base's surface: must be 0
};

/// Measures the distances of every disk to the base and to its neighbours, independently of the engine's
/// predictions. @param time local to the epoch
Audit audit(const SystemState& system, double time);

/// @throws std::invalid_argument if a disk overlaps another or the base, or is outside the machine; the
/// message names the entries of `initial`
void refuseBadStart(const SystemState& system, double time);

}  // namespace ratchet_sieve
