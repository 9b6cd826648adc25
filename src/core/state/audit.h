#pragma once

#include <cstddef>

namespace ratchet_sieve
{

class MachineState;

/// What a check of all disks at one time has found.
struct Audit
{
  double largest_overlap = 0.0;    ///< of two disks, or of a disk and the base [m]
  std::size_t behind_surface = 0;  ///< disks whose centre is below the base's surface: must be 0
};

/// Measures every disk against the base and against its neighbours, by distances alone: nothing of
/// the engine's predictions is used. @param time local to the epoch
Audit audit(const MachineState& machine, double time);

/// @throws std::invalid_argument if a disk overlaps another or the base, or lies outside the
/// machine; names the entries of `initial`
void refuseBadStart(const MachineState& machine, double time);

}  // namespace ratchet_sieve
